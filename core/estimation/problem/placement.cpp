// SPDX-License-Identifier: Apache-2.0
// Where the effects of the model put every observation's chain, and how their numbers move it.
#include <algorithm>
#include <optional>

#include "base/threads.h"
#include "estimation/problem/problem.h"
#include "estimation/problem/robot_scale.h"
#include "robot/posture_memory.h"
#include "robot/posture_tangent.h"

namespace handsight {
namespace {

void clear(Sites& sites) {
  // Their memory stays: this is asked for every observation and many of its columns.
  auto joints = std::move(sites.robot.joints);
  auto markers = std::move(sites.markers);
  sites = Sites{};
  std::fill(joints.begin(), joints.end(), JointChange{});
  std::fill(markers.begin(), markers.end(), Vector3::Zero());
  sites.robot.joints = std::move(joints);
  sites.markers = std::move(markers);
}

/// The sites as the terms of a problem move them, observation after observation; its memory serves all of them.
class MovedSites {
 public:
  explicit MovedSites(const Problem& problem)
      : problem_(&problem), all_(unmoved_sites(problem.source->chain)), unit_(all_) {
    for (const EffectTerm& term : problem.terms) {
      effects_.push_back(&term_effect(term));
      if (effects_.back()->scope == EffectScope::marker && term.place >= static_cast<int>(all_.markers.size()))
        all_.markers.resize(static_cast<std::size_t>(term.place + 1), Vector3::Zero());
    }
    unit_.markers = all_.markers;
    if (problem.terms.empty()) all_.robot.joints.clear();
  }

  /// By all terms at their values.
  const Sites& by_all(const ObservationState& c) {
    clear(all_);
    for (std::size_t t = 0; t < effects_.size(); ++t)
      effects_[t]->move(c, problem_->terms[t].place, problem_->terms[t].values, all_);
    return all_;
  }

  /// As a unit of one column moves them, choices of its term as they are.
  const Sites& by_unit(const ObservationState& c, const EffectColumn& column) {
    const EffectTerm& term = problem_->terms[column.term];
    const Effect& effect = *effects_[column.term];
    if (joint_ >= 0)
      unit_.robot.joints[static_cast<std::size_t>(joint_)] = JointChange{};
    else
      clear(unit_);
    values_.assign(effect.parameters.size(), 0.0);
    for (std::size_t p = 0; p < values_.size(); ++p)
      if (effect.parameters[p].is_choice) values_[p] = term.values[p];
    values_[column.parameter] = 1;
    effect.move(c, term.place, values_, unit_);
    joint_ = moves_one_joint(effect) ? term.place : -1;
    return unit_;
  }

  /// The joint that the last column moves alone, or -1.
  int joint() const { return joint_; }

  PostureMemory& memory() { return memory_; }

 private:
  const Problem* problem_;
  std::vector<const Effect*> effects_;  // per term
  std::vector<double> values_;
  Sites all_, unit_;
  PostureMemory memory_;
  int joint_ = -1;
};

/// A slip of the body, a motion in the slip's frame, as a motion in the TCP's.
Rigid slip_in_tcp(const Rigid& tcp_from_slip, const Sites& sites) {
  return tcp_from_slip * small_motion<double>(sites.body) * inverse(tcp_from_slip);
}

/// How motions at the chain's other sites move the TCP and the sensor.
struct SiteMotions {
  Matrix6 by_body, by_hand, by_mount, by_drift;
};

SiteMotions site_motions(const Rigid& tcp_from_slip, const Sites& sites, const Rigid& root_from_tcp) {
  SiteMotions m;
  const Rigid root_from_hand = root_from_tcp * small_motion<double>(sites.hand);
  const Rigid mount = small_motion<double>(sites.mount), drift = small_motion<double>(sites.drift);
  m.by_body = adjoint(root_from_hand * tcp_from_slip) * small_motion_jacobian(sites.body);
  m.by_hand = adjoint(root_from_tcp) * small_motion_jacobian(sites.hand);
  m.by_mount = adjoint(inverse(mount * drift)) * small_motion_jacobian(sites.mount);
  m.by_drift = adjoint(inverse(drift)) * small_motion_jacobian(sites.drift);
  return m;
}

void set_motion(const Problem& problem, const ObservationState& c, const Posture& posture, MovedSites& moved,
                const Sites& sites, ProblemObservation& o) {
  const Chain& chain = *c.chain;
  const Rigid& slip_frame = problem.slip_frame(chain.body);
  const PostureTangent tangent(chain.robot, sites.robot, chain.gravity, posture, chain.tcp_link, chain.mount_link);
  EffectMotion& motion = o.motion;
  motion.tcp_by_effect.setZero(6, problem.effect_count());
  motion.sensor_by_effect.resize(6, 0);
  motion.markers.clear();
  motion.tcp_by_value.resize(6, static_cast<Eigen::Index>(chain.joints.size()));
  for (std::size_t j = 0; j < chain.joints.size(); ++j)
    motion.tcp_by_value.col(static_cast<Eigen::Index>(j)) = tangent.motion_by_value(chain.joints[j]);
  motion.torques =
      Eigen::Map<const Eigen::VectorXd>(posture.torque.data(), static_cast<Eigen::Index>(posture.torque.size()));
  std::optional<SiteMotions> by;
  for (Eigen::Index i = 0; i < problem.effect_count(); ++i) {
    const Sites& d = moved.by_unit(c, problem.columns_of_effects[static_cast<std::size_t>(i)]);
    if (moved.joint() >= 0) {
      const auto j = static_cast<std::size_t>(moved.joint());
      motion.tcp_by_effect.col(i) = tangent.motion_by_joint(j, d.robot.joints[j]);
      continue;
    }
    if (!by) by = site_motions(slip_frame, sites, posture.root_from_link[static_cast<std::size_t>(chain.tcp_link)]);
    motion.tcp_by_effect.col(i) = tangent.motion(d.robot);
    if (!d.hand.isZero(0)) motion.tcp_by_effect.col(i) += by->by_hand * d.hand;
    if (!d.body.isZero(0)) motion.tcp_by_effect.col(i) += by->by_body * d.body;
    if (!d.mount.isZero(0) || !d.drift.isZero(0)) {
      if (motion.sensor_by_effect.cols() == 0) motion.sensor_by_effect.setZero(6, problem.effect_count());
      motion.sensor_by_effect.col(i) = by->by_mount * d.mount + by->by_drift * d.drift;
    }
    for (std::size_t m = 0; m < d.markers.size(); ++m)
      if (!d.markers[m].isZero(0))
        motion.markers.push_back({static_cast<int>(m), i, slip_frame.rotation * d.markers[m]});
  }
  std::ranges::stable_sort(motion.markers, {}, &EffectMotion::MarkerColumn::marker);
}

bool is_nothing(const Deflection& d) {
  return d.base.isZero(0) && std::all_of(d.angle.begin(), d.angle.end(), [](double a) { return a == 0; }) &&
         std::all_of(d.lateral.begin(), d.lateral.end(), [](const Vector3& l) { return l.isZero(0); });
}

/// `derives`: EffectMotion too; else it stays as it was.
void place(const Problem& problem, bool derives, MovedSites& moved, ProblemObservation& o) {
  const ObservationState& c = problem.source->states[static_cast<std::size_t>(o.index)];
  const Chain& chain = *c.chain;
  const Sites& sites = moved.by_all(c);
  const auto solved = [&](const Deflection* start) -> const Posture& {
    return moved.memory().solve(chain.robot, c.sensor, sites.robot, chain.gravity, derives, start);
  };
  const Posture& posture = solved(&o.deflection);
  if (!posture.converged) solved(nullptr);  // a start from softer springs may lie beyond what is stable
  o.root_from_tcp = posture.root_from_link[static_cast<std::size_t>(chain.tcp_link)];
  o.root_from_mount = posture.root_from_link[static_cast<std::size_t>(chain.mount_link)];
  o.springs_hold = posture.converged;
  o.sensor_moves = !sites.mount.isZero(0) || !sites.drift.isZero(0);
  o.sensor_motion = o.sensor_moves ? small_motion<double>(sites.mount) * small_motion<double>(sites.drift) : Rigid{};
  if (!sites.hand.isZero(0)) o.root_from_tcp = o.root_from_tcp * small_motion<double>(sites.hand);
  if (!sites.body.isZero(0)) o.root_from_tcp = o.root_from_tcp * slip_in_tcp(problem.slip_frame(chain.body), sites);
  o.marker_shifts.clear();
  if (std::any_of(sites.markers.begin(), sites.markers.end(), [](const Vector3& m) { return !m.isZero(0); }))
    for (const Vector3& m : sites.markers) o.marker_shifts.push_back(problem.slip_frame(chain.body).rotation * m);
  if (derives) set_motion(problem, c, posture, moved, sites, o);
  // What does not bend starts from nothing; of a long session every number counts.
  if (is_nothing(posture.deflection))
    o.deflection = Deflection{};
  else
    o.deflection = posture.deflection;
}

/// What the rig's numbers do as a unit of an effect moves the cameras' sites by `d`.
void set_numbers(const Sites& sites, const Sites& d, int cameras, Eigen::Ref<Eigen::VectorXd> numbers) {
  for (int c = 0; c < cameras; ++c) {
    const auto at = static_cast<std::size_t>(c);
    numbers.segment<camera_number_count>(first_number(cameras, c)) = d.cameras[at].numbers;
    if (c > 0)
      numbers.segment<6>(motion_number(c)) = small_motion_jacobian(sites.cameras[at].motion) * d.cameras[at].motion;
  }
}

/// Cameras and rig move alike in all observations; only the chain's observation states are needed.
void place_cameras(Problem& problem) {
  const Chain& chain = problem.source->chain;
  if (!chain.rig || !problem.rig) return;
  MovedSites moved(problem);
  const ObservationState c = states_at(chain, Eigen::VectorXd::Zero(static_cast<Eigen::Index>(chain.joints.size())));
  const Sites& sites = moved.by_all(c);
  if (!problem.terms.empty()) problem.rig = moved_rig(*chain.rig, sites);
  problem.cameras_by_effect.resize(0, 0);
  for (Eigen::Index i = 0; i < problem.effect_count(); ++i) {
    const Sites& d = moved.by_unit(c, problem.columns_of_effects[static_cast<std::size_t>(i)]);
    if (std::all_of(d.cameras.begin(), d.cameras.end(), [](const CameraChange& one) { return one.is_zero(); }))
      continue;
    if (problem.cameras_by_effect.cols() == 0)
      problem.cameras_by_effect.setZero(rig_number_count(chain.rig->count()), problem.effect_count());
    set_numbers(sites, d, chain.rig->count(), problem.cameras_by_effect.col(i));
  }
}

/// Each by itself, in parts that are worth a thread.
void place_each(bool derives, Problem& problem) {
  constexpr std::size_t of_a_part = 16;
  const std::size_t count = problem.observations.size(), parts = (count + of_a_part - 1) / of_a_part;
  each_part(static_cast<int>(parts), parts >= 3, [&](int part) {
    MovedSites moved(problem);
    const std::size_t first = static_cast<std::size_t>(part) * of_a_part;
    for (std::size_t i = first; i < std::min(first + of_a_part, count); ++i)
      place(problem, derives, moved, problem.observations[i]);
  });
}

}  // namespace

Problem with_motions(const Problem& problem) {
  Problem filled = problem;
  if (problem.effect_count() > 0 || problem.with_motions) return filled;
  filled.with_motions = true;
  place_observations(filled);
  return filled;
}

void place_observations(Problem& problem) {
  place_cameras(problem);
  follow_robot_scale(problem);
  place_each(problem.effect_count() > 0 || problem.with_motions, problem);
}

void follow_effects(Problem& problem, const Eigen::VectorXd& values) {
  set_effect_values(problem, values);
  place_cameras(problem);
  follow_robot_scale(problem);
  place_each(false, problem);
}

}  // namespace handsight
