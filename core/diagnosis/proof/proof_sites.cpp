// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/proof/proof_sites.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <regex>

#include "diagnosis/curves/place_formulas.h"
#include "diagnosis/ranking/curves.h"
#include "effects/own_effect.h"
#include "effects/units.h"

namespace handsight {
namespace {

enum class EntryKind { angle, compliance, bend, gap, motion, length, tilt, other };

struct Entry {
  EntryKind kind = EntryKind::other;
  int joint = -1;           // of the robot; of `length`: the marker
  int axis = 0;             // of a motion: x y z rx ry rz
  const char* frame = "";   // of a motion: whose
  double* value = nullptr;  // in the Sites
};

/// Every number of the sites, in an order of their own that all Sites of a chain share.
std::vector<Entry> entries_of(Sites& s) {
  std::vector<Entry> all;
  const auto six = [&](Vector6& v, const char* frame, int joint) {
    for (int i = 0; i < 6; ++i) all.push_back({EntryKind::motion, joint, i, frame, &v[i]});
  };
  for (std::size_t j = 0; j < s.robot.joints.size(); ++j) {
    JointChange& c = s.robot.joints[j];
    const auto joint = static_cast<int>(j);
    all.push_back({EntryKind::angle, joint, 0, "", &c.angle});
    all.push_back({EntryKind::compliance, joint, 0, "", &c.compliance});
    all.push_back({EntryKind::bend, joint, 0, "", &c.lateral_compliance});
    all.push_back({EntryKind::gap, joint, 0, "", &c.gap});
    all.push_back({EntryKind::other, joint, 0, "", &c.multiplier_error});
    all.push_back({EntryKind::other, joint, 0, "", &c.share});
    six(c.frame, "frame", joint);
    six(c.after, "link behind it", joint);
  }
  six(s.mount, "mount", -1);
  six(s.drift, "mount", -1);
  six(s.hand, "hand", -1);
  six(s.body, "marker body", -1);
  all.push_back({EntryKind::tilt, -1, 0, "", &s.robot.tilt_x});
  all.push_back({EntryKind::tilt, -1, 1, "", &s.robot.tilt_y});
  for (std::size_t m = 0; m < s.markers.size(); ++m)
    for (int i = 0; i < 3; ++i) all.push_back({EntryKind::length, static_cast<int>(m), i, "", &s.markers[m][i]});
  for (CameraChange& camera : s.cameras) {
    for (int i = 0; i < 6; ++i) all.push_back({EntryKind::motion, -1, i, "camera", &camera.motion[i]});
    for (int i = 0; i < camera_number_count; ++i) all.push_back({EntryKind::other, -1, i, "", &camera.numbers[i]});
  }
  for (int i = 0; i < 3; ++i) all.push_back({EntryKind::other, -1, i, "", &s.robot.base_compliance[i]});
  all.push_back({EntryKind::other, -1, 0, "", &s.robot.payload_mass});
  for (int i = 0; i < 3; ++i) all.push_back({EntryKind::other, -1, i, "", &s.robot.payload_moment[i]});
  return all;
}

/// What one unit of the number moves in every observation: observations x entries.
Eigen::MatrixXd moved_entries(const Problem& p, const EffectTerm& term, std::size_t parameter) {
  const Effect& effect = term_effect(term);
  std::vector<double> values(effect.parameters.size(), 0.0);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (effect.parameters[i].is_choice) values[i] = term.values[i];
  values[parameter] = 1;
  Eigen::MatrixXd moved;
  for (std::size_t i = 0; i < p.observations.size(); ++i) {
    Sites sites = unmoved_sites(p.source->chain);
    const auto at = static_cast<std::size_t>(p.observations[i].index);
    effect.move(p.source->states[at], term.place, values, sites);
    const std::vector<Entry> entries = entries_of(sites);
    if (i == 0)
      moved.resize(static_cast<Eigen::Index>(p.observations.size()), static_cast<Eigen::Index>(entries.size()));
    for (std::size_t e = 0; e < entries.size(); ++e)
      moved(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(e)) = *entries[e].value;
  }
  return moved;
}

template <class Value>
Eigen::VectorXd per_observation(const Problem& p, const Value& value) {
  Eigen::VectorXd all(static_cast<Eigen::Index>(p.observations.size()));
  for (std::size_t i = 0; i < p.observations.size(); ++i) {
    const ProblemObservation& o = p.observations[i];
    all[static_cast<Eigen::Index>(i)] = value(o, p.source->states[static_cast<std::size_t>(o.index)]);
  }
  return all;
}

/// The moment of gravity across the joint's axis, of the nominal robot.
double moment_across(const Chain& chain, const ObservationState& c, int joint) {
  const Posture posture = solve_posture(chain.robot, c.sensor, chain.gravity);
  const auto j = static_cast<std::size_t>(joint);
  const Vector3 axis = posture.root_from_joint[j].rotation * chain.robot.joints[j].axis;
  return (posture.moment[j] - axis * axis.dot(posture.moment[j])).norm();
}

struct Followed {
  Message name;
  std::string unit;
  Eigen::VectorXd values;
};

Followed angle_of(const Problem& p, int joint) {
  const Joint& j = p.source->chain.robot.joints[static_cast<std::size_t>(joint)];
  const bool slides = j.kind == JointKind::prismatic;
  return {slides ? message("position of {}", j.name) : message("angle of {}", j.name), slides ? "m" : "rad",
          per_observation(p, [&](const auto&, const ObservationState& c) { return c.sensor[joint]; })};
}

Followed torque_of(const Problem& p, int joint) {
  const Joint& j = p.source->chain.robot.joints[static_cast<std::size_t>(joint)];
  return {message("gravity torque at {}", j.name), j.kind == JointKind::prismatic ? "N" : "N m",
          per_observation(p, [&](const ProblemObservation& o, const auto&) { return o.motion.torques[joint]; })};
}

Followed approach_of(const Problem& p, int joint) {
  return {
      message("direction in which {} last moved", p.source->chain.robot.joints[static_cast<std::size_t>(joint)].name),
      "sign", per_observation(p, [&](const auto&, const ObservationState& c) { return c.approach[joint]; })};
}

Followed velocity_of(const Problem& p, int joint) {
  const Joint& j = p.source->chain.robot.joints[static_cast<std::size_t>(joint)];
  return {message("velocity of {}", j.name), j.kind == JointKind::prismatic ? "m/s" : "rad/s",
          per_observation(p, [&](const auto&, const ObservationState& c) { return c.velocity[joint]; })};
}

Followed order(const Problem& p) {
  return {"order of the observations", "number",
          per_observation(p, [](const auto&, const ObservationState& c) { return static_cast<double>(c.order); })};
}

Followed time_or_order(const Problem& p) {
  Followed time{"time", "s", per_observation(p, [](const auto&, const ObservationState& c) { return c.elapsed; })};
  return time.values.size() > 0 && time.values.maxCoeff() > time.values.minCoeff() ? time : order(p);
}

bool in_proportion(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  const double together = a.dot(b);
  return b.squaredNorm() > 0 && together * together > (1 - 1e-12) * a.squaredNorm() * b.squaredNorm();
}

/// "distance from the sensor" of a curve's title, where that is what it follows.
std::optional<Followed> locate(const Problem& p, const Effect& effect, const std::string& variable) {
  if (effect.is_unnamed())
    if (const auto place = followed_place(p, *effect.definition)) {
      const std::string name = followed_variable(*effect.definition);
      return Followed{looked_up(name), name.starts_with("image") ? "px" : "m", place->values};
    }
  for (int axis = 0; axis < 3; ++axis)
    if (variable == std::string("tcp_") + "xyz"[axis])
      return Followed{message("place of the TCP along {} of the sensor's link", "xyz"[axis]), "m",
                      per_observation(p, [&](const auto&, const ObservationState& c) {
                        return (c.tcp ? *c.tcp : nominal_tcp(p.source->chain, c.sensor))[axis];
                      })};
  return std::nullopt;
}

/// The first variable that the formulas of an effect by formula name.
std::optional<Followed> named_in_formula(const Problem& p, const Effect& effect, int place) {
  if (!effect.definition) return std::nullopt;
  const Robot& robot = p.source->chain.robot;
  static const std::regex word("[A-Za-z_][A-Za-z0-9_]*");
  for (const DefinedMove& m : effect.definition->moves)
    for (std::sregex_iterator i(m.formula.begin(), m.formula.end(), word), end; i != end; ++i) {
      const std::string name = i->str();
      if (place >= 0 && name == "q") return angle_of(p, place);
      if (place >= 0 && name == "tau") return torque_of(p, place);
      if (place >= 0 && name == "velocity") return velocity_of(p, place);
      if (place >= 0 && name == "approach") return approach_of(p, place);
      if (name == "time" || name == "seconds") return time_or_order(p);
      if (name == "order") return order(p);
      if (name.starts_with("tcp_")) return locate(p, effect, name);
      for (std::size_t j = 0; j < robot.joints.size(); ++j) {
        if (!robot.joints[j].moves()) continue;
        if (name == "q_" + formula_name(robot.joints[j].name)) return angle_of(p, static_cast<int>(j));
        if (name == "tau_" + formula_name(robot.joints[j].name)) return torque_of(p, static_cast<int>(j));
      }
    }
  return std::nullopt;
}

/// What a share follows that no load gives: direction and velocity where it is in proportion to them, else the own
/// joint's angle; a step the order, everything else of the session the time.
Followed followed(const Problem& p, const Effect& effect, int place, const Eigen::VectorXd& share) {
  if (auto named = named_in_formula(p, effect, place)) return *named;
  if (moves_one_joint(effect)) {
    for (Followed f : {approach_of(p, place), velocity_of(p, place)})
      if (in_proportion(share, f.values)) return f;
    return angle_of(p, place);
  }
  const bool is_step = (share.array() == 0 || share.array() == 1).all() && share.minCoeff() < share.maxCoeff();
  return is_step ? order(p) : time_or_order(p);
}

Message motion_text(const Entry& e, const Robot& robot) {
  constexpr const char* axes = "xyz";
  const char axis = axes[e.axis % 3];
  if (e.joint < 0) {
    const Message whose = message("the {}", e.frame);
    return e.axis < 3 ? message("shift along {} of {}", axis, whose) : message("turn about {} of {}", axis, whose);
  }
  const std::string& joint = robot.joints[static_cast<std::size_t>(e.joint)].name;
  return e.axis < 3 ? message("shift along {} at {}", axis, joint) : message("turn about {} at {}", axis, joint);
}

/// What moves where this entry does, with its unit; empty: no scalar motion.
std::pair<Message, std::string> quantity_of(const Entry& e, const Robot& robot) {
  constexpr const char* axes = "xyz";
  const Joint* joint =
      e.joint >= 0 && e.kind != EntryKind::length ? &robot.joints[static_cast<std::size_t>(e.joint)] : nullptr;
  const bool slides = joint && joint->kind == JointKind::prismatic;
  switch (e.kind) {
    case EntryKind::angle:
    case EntryKind::compliance:
    case EntryKind::gap:
      return {message("error of {}", joint->name), slides ? "m" : "rad"};
    case EntryKind::bend:
      return {message("bend across the axis of {}", joint->name), "rad"};
    case EntryKind::motion:
      return {motion_text(e, robot), e.axis < 3 ? "m" : "rad"};
    case EntryKind::length:
      return {message("shift along {} of marker {}", axes[e.axis], e.joint), "m"};
    case EntryKind::tilt:
      return {message("tilt of the base about {}", axes[e.axis]), "rad"};
    default:
      return {};
  }
}

/// What loads a spring or a gap, and what it follows.
std::optional<Followed> load_of(const Problem& p, const Entry& e) {
  constexpr double flank_torque = posture_detail::backlash_torque;
  switch (e.kind) {
    case EntryKind::compliance:
    case EntryKind::gap: {
      Followed torque = torque_of(p, e.joint);
      if (e.kind == EntryKind::gap) torque.values = (torque.values / flank_torque).array().tanh();
      return torque;
    }
    case EntryKind::bend:
      return Followed{message("gravity's moment across the axis of {}",
                              p.source->chain.robot.joints[static_cast<std::size_t>(e.joint)].name),
                      "N m", per_observation(p, [&](const auto&, const ObservationState& c) {
                        return moment_across(p.source->chain, c, e.joint);
                      })};
    default:
      return std::nullopt;
  }
}

}  // namespace

ProofSite proof_site(const Problem& p, const EffectTerm& term, std::size_t parameter) {
  const Effect& effect = term_effect(term);
  const EffectParameter& number = effect.parameters[parameter];
  const Eigen::MatrixXd moved = moved_entries(p, term, parameter);
  std::optional<Eigen::Index> entry;
  int count = 0;
  for (Eigen::Index e = 0; e < moved.cols(); ++e)
    if (!moved.col(e).isZero(0)) {
      if (count++ == 0) entry = e;
    }
  ProofSite site;
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(p.observations.size()));
  site.load = ones;
  if (count == 1) {
    Sites sites = unmoved_sites(p.source->chain);
    const Entry at = entries_of(sites)[static_cast<std::size_t>(*entry)];
    std::tie(site.quantity, site.unit) = quantity_of(at, p.source->chain.robot);
    if (!site.quantity.empty()) {
      site.entry = static_cast<std::size_t>(*entry);
      site.share = moved.col(*entry);
      if (const auto load = load_of(p, at)) {
        site.load = load->values;
        site.share = site.share.cwiseProduct(load->values);
        const Followed by = at.kind == EntryKind::gap ? torque_of(p, at.joint) : *load;
        site.against = by.name, site.against_unit = by.unit, site.x = by.values;
        return site;
      }
    }
  }
  if (!site.entry) {
    site.quantity = looked_up(number.name);
    site.unit = unit_at(effect, parameter, term.place, p.source->chain.robot);
    site.share = ones;
  }
  const Followed by = followed(p, effect, term.place, site.share);
  site.against = by.name, site.against_unit = by.unit, site.x = by.values;
  return site;
}

std::shared_ptr<const Effect> make_probe(std::size_t entry) {
  auto probe = std::make_shared<Effect>();
  probe->id = fmt::format("probe_{}", entry);
  probe->scope = EffectScope::session;
  probe->parameters = {{"size", "", 1}};
  probe->move = [entry](const ObservationState&, int, std::span<const double> values, Sites& sites) {
    *entries_of(sites)[entry].value += values[0];
  };
  return probe;
}

}  // namespace handsight
