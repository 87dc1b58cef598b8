// SPDX-License-Identifier: Apache-2.0
#include "export/rigid/held_sites.h"

#include <algorithm>
#include <random>

#include "base/text.h"
#include "effects/units.h"

namespace handsight {
namespace {

/// All numbers of the sites, in one order.
std::vector<double> flat(const Sites& s) {
  std::vector<double> all;
  const auto add = [&](const auto& v) { all.insert(all.end(), v.data(), v.data() + v.size()); };
  for (const JointChange& c : s.robot.joints) {
    all.insert(all.end(), {c.angle, c.multiplier_error, c.share, c.compliance, c.lateral_compliance, c.gap});
    add(c.frame);
    add(c.after);
  }
  all.insert(all.end(), {s.robot.tilt_x, s.robot.tilt_y, s.robot.payload_mass});
  add(s.robot.base_compliance);
  add(s.robot.payload_moment);
  add(s.mount);
  add(s.drift);
  for (const CameraChange& c : s.cameras) {
    add(c.motion);
    add(c.numbers);
  }
  add(s.hand);
  add(s.body);
  for (const Vector3& m : s.markers) add(m);
  return all;
}

/// Does the term move its sites by the same amount in every pose after the session?
bool is_the_same_everywhere(const Chain& chain, const EffectTerm& term) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<double> first;
  for (int draw = 0; draw < 4; ++draw) {
    Eigen::VectorXd position(static_cast<Eigen::Index>(chain.joints.size()));
    for (double& q : position) q = uniform(random);
    ObservationState c = states_at(chain, position);
    for (double& v : c.velocity) v = uniform(random);
    for (double& a : c.approach) a = uniform(random);
    const std::vector<double> here = flat(moved_sites(c, {term}));
    if (draw == 0) first = here;
    if (here != first) return false;
  }
  return true;
}

/// Is anything left of the sites when all that a rigid file holds is taken out?
bool has_more_than_is_held(Sites s) {
  for (JointChange& c : s.robot.joints) {
    c.angle = c.multiplier_error = 0;
    c.frame.setZero();
    c.after.setZero();
  }
  s.hand.setZero();
  s.body.setZero();
  s.mount.setZero();
  s.drift.setZero();
  const std::vector<double> rest = flat(s);
  return std::any_of(rest.begin(), rest.end(), [](double x) { return x != 0; });
}

std::string list_numbers(const EffectTerm& term, const Robot& robot) {
  const Effect& effect = term_effect(term);
  std::string text;
  for (std::size_t p = 0; p < term.values.size(); ++p)
    text += fmt::format("{}{} {:.4g} {}", p ? ", " : "", effect.parameters[p].name, term.values[p],
                        unit_at(effect, p, term.place, robot));
  return text;
}

void add_springs(const Robot& robot, HeldSites& held) {
  for (const Joint& joint : robot.joints) {
    if (joint.stiffness > 0)
      held.left_out.push_back(message("the spring of {} ({:.4g} {})", joint.name, joint.stiffness,
                                      joint.kind == JointKind::prismatic ? "N/m" : "N m/rad"));
    if (joint.mimics.size() > 1)
      held.remarks.push_back(message("{} follows {} joints: other readers may take one of its <mimic> alone",
                                     joint.name, joint.mimics.size()));
  }
}

}  // namespace

HeldSites held_sites(const CalibratedRobot& robot) {
  HeldSites held;
  std::vector<EffectTerm> constant;
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(robot.chain.joints.size()));
  const ObservationState c = states_at(robot.chain, zero);
  for (const EffectTerm& term : robot.model.effects) {
    if (std::all_of(term.values.begin(), term.values.end(), [](double v) { return v == 0; })) continue;
    const bool is_constant = is_the_same_everywhere(robot.chain, term);
    if (is_constant) constant.push_back(term);
    if (is_constant && !has_more_than_is_held(moved_sites(c, {term}))) continue;
    const std::string where = place_name(term_effect(term), term.place, robot.chain.robot);
    held.left_out.push_back(message("{}{} ({})", term.id, where.empty() ? Message() : message(" of {}", where),
                                    shortened(list_numbers(term, robot.chain.robot), 300)));
  }
  held.sites = moved_sites(c, constant);
  held.sites.robot.joints.resize(robot.chain.robot.joints.size());
  held.sites.robot = rigid_part(held.sites.robot);
  add_springs(robot.chain.robot, held);
  return held;
}

RobotChange rigid_part(const RobotChange& change) {
  RobotChange rigid;
  for (const JointChange& c : change.joints) {
    JointChange& kept = rigid.joints.emplace_back();
    kept.angle = c.angle;
    kept.multiplier_error = c.multiplier_error;
    kept.frame = c.frame;
    kept.after = c.after;
  }
  return rigid;
}

}  // namespace handsight
