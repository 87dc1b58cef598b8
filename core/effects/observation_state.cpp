// SPDX-License-Identifier: Apache-2.0
#include "effects/observation_state.h"

#include <algorithm>

#include "robot/posture_memory.h"
#include "session/by_time.h"

namespace handsight {
namespace {

/// Per joint of the robot from a vector in the session's order; empty: zeros.
Eigen::VectorXd per_robot_joint(const Chain& chain, const Eigen::VectorXd& values, bool with_offsets) {
  if (values.size() == 0) return Eigen::VectorXd::Zero(static_cast<Eigen::Index>(chain.robot.joints.size()));
  Eigen::VectorXd all = joint_values(chain.robot, chain.joints, values);
  if (with_offsets) return all;
  // Rates have no offsets: what a mimic joint has at zero is taken away.
  return all - joint_values(chain.robot, chain.joints, Eigen::VectorXd::Zero(values.size()));
}

double sign(double x) { return x > 0 ? 1.0 : x < 0 ? -1.0 : 0.0; }

}  // namespace

std::vector<ObservationState> observation_states(const Session& session, const Chain& chain) {
  const std::vector<int> order = by_time(session);
  const auto at = [&](int index) -> const Observation& {
    return session.observations[static_cast<std::size_t>(index)];
  };
  std::vector<ObservationState> all(order.size());
  const ObservationState* before = nullptr;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const Observation& o = at(order[k]);
    ObservationState& c = all[static_cast<std::size_t>(order[k])];
    c.chain = chain.parts.empty() ? &chain : &chain.parts[static_cast<std::size_t>(o.part)];
    c.sensor = per_robot_joint(chain, o.position, true);
    c.velocity = per_robot_joint(chain, o.velocity, false);
    c.approach.resize(c.sensor.size());
    const double start = o.whole ? o.whole->start : at(order.front()).time;
    const double end = o.whole ? o.whole->end : at(order.back()).time;
    c.elapsed = o.time - start;
    c.duration = end - start;
    c.order = o.whole ? o.whole->order : static_cast<int>(k);
    std::optional<Eigen::VectorXd> from;
    if (o.whole && o.whole->position_before.size() > 0) from = per_robot_joint(chain, o.whole->position_before, true);
    if (!o.whole && before) from = before->sensor;
    for (Eigen::Index j = 0; j < c.sensor.size(); ++j)
      c.approach[j] = c.velocity[j] != 0 ? sign(c.velocity[j]) : from ? sign(c.sensor[j] - (*from)[j]) : 0.0;
    before = &c;
  }
  return all;
}

ObservationState states_at(const Chain& chain, const Eigen::VectorXd& position) {
  ObservationState c;
  c.chain = &chain;
  c.sensor = per_robot_joint(chain, position, true);
  c.velocity = c.approach = Eigen::VectorXd::Zero(c.sensor.size());
  c.elapsed = c.duration = 1;
  c.order = 1 << 30;
  return c;
}

Eigen::VectorXd nominal_torques(const Chain& chain, const Eigen::VectorXd& sensor) {
  const Posture posture = solve_posture(chain.robot, sensor, chain.gravity);
  return Eigen::Map<const Eigen::VectorXd>(posture.torque.data(), static_cast<Eigen::Index>(posture.torque.size()));
}

Vector3 nominal_tcp(const Chain& chain, const Eigen::VectorXd& sensor) {
  const Posture posture = solve_posture(chain.robot, sensor, chain.gravity);
  return inverse(posture.root_from_link[static_cast<std::size_t>(chain.mount_link)]) *
         posture.root_from_link[static_cast<std::size_t>(chain.tcp_link)].translation;
}

std::vector<double> list_times(const Session& session) {
  std::vector<double> times;
  for (const Observation& o : session.observations) times.push_back(o.time);
  std::sort(times.begin(), times.end());
  return times;
}

std::vector<ObservationState> states_at(const Chain& chain, const std::vector<DrivenPose>& poses,
                                        const std::vector<double>& times) {
  std::vector<ObservationState> all;
  for (const DrivenPose& pose : poses) {
    ObservationState c = states_at(chain, pose.position);
    c.velocity = per_robot_joint(chain, pose.velocity, false);
    for (Eigen::Index j = 0; j < c.sensor.size(); ++j)
      c.approach[j] = c.velocity[j] != 0 ? sign(c.velocity[j])
                      : all.empty()      ? 0.0
                                         : sign(c.sensor[j] - all.back().sensor[j]);
    if (pose.time && !times.empty()) {
      c.elapsed = *pose.time - times.front();
      c.duration = times.back() - times.front();
      c.order = static_cast<int>(std::upper_bound(times.begin(), times.end(), *pose.time) - times.begin()) - 1;
    }
    all.push_back(std::move(c));
  }
  return all;
}

ObservedEnds observed_ends(const ObservationState& c, const Sites& sites) {
  const Chain& chain = *c.chain;
  const Posture posture = solve_equilibrium(chain.robot, c.sensor, sites.robot, chain.gravity, false);
  return {{posture.root_from_link[static_cast<std::size_t>(chain.tcp_link)] * small_motion<double>(sites.hand),
           posture.root_from_link[static_cast<std::size_t>(chain.mount_link)], posture.converged},
          small_motion<double>(sites.mount) * small_motion<double>(sites.drift)};
}

Rig moved_rig(const Rig& rig, const Sites& sites) {
  Rig moved = rig;
  for (int c = 0; c < rig.count(); ++c) {
    const CameraChange& change = sites.cameras[static_cast<std::size_t>(c)];
    RigCamera& camera = moved.at(c);
    if (c > 0) camera.camera_from_first = small_motion<double>(change.motion) * camera.camera_from_first;
    const auto numbers = camera_numbers(camera.camera);
    for (int i = 0; i < camera_number_count; ++i)
      camera.camera.*numbers[static_cast<std::size_t>(i)].value += change.numbers[i];
  }
  return moved;
}

}  // namespace handsight
