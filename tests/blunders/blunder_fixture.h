// SPDX-License-Identifier: Apache-2.0
// Sessions with a blunder that is known: simulated right, then read wrongly.
#pragma once

#include <gmock/gmock.h>

#include <numbers>
#include <random>

#include "blunders/find_blunders.h"
#include "fixtures/random_robot.h"
#include "fixtures/targets.h"
#include "robot/robot.h"
#include "session/pose_points.h"

namespace handsight::fixture {

inline Session simulated_right(const Session& like, std::uint64_t seed, const std::vector<EffectTerm>& effects = {}) {
  SimulationOptions o;
  o.observations = 40;
  o.seed = seed;
  o.effects = effects;
  o.farthest = 3;
  return simulate_session(like, o).session;
}

inline Session with_free_mount(Session s) {
  s.mount.estimate = true;
  return s;
}

inline Session six_axes(std::uint64_t seed = 1) { return simulated_right(with_free_mount(stand_session(4)), seed); }
inline Session seven_axes(std::uint64_t seed = 1) {
  return simulated_right(with_free_mount(seven_axis_session(4)), seed);
}

/// Column j of the readings, changed one by one.
template <class Change>
Session with_joint(Session s, const std::string& joint, const Change& change) {
  const auto j = std::find(s.joints.begin(), s.joints.end(), joint) - s.joints.begin();
  for (Observation& o : s.observations) o.position[j] = change(o.position, o.position[j]);
  return s;
}

inline Session turned(const Session& s, const std::string& joint) {
  return with_joint(s, joint, [](const auto&, double q) { return -q; });
}

/// Poses of a flange with a camera before a board, nothing wrong: 0.3 mm and 0.5 mrad of noise.
inline Session pose_session(std::uint64_t seed, int count = 24) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const auto three = [&](double size) { return Vector3(size * drawn_3([&] { return normal(random); })); };
  const Rigid flange_from_camera{rotation_from_rpy({0.03, -0.05, 1.54}), {0.06, -0.03, 0.05}};
  const Rigid base_from_board{rotation_from_rpy({0.02, 0.03, 0.5}), {0.55, 0.08, 0.01}};
  Session s;
  s.file = "session.xml";
  s.robot = poses_robot();
  s.joints = joint_names(s.robot);
  s.tcp = "base";
  s.mount = {"flange", Rigid{}, true, false};
  s.pose_sensor = PoseSensor{};
  for (int i = 0; i < count; ++i) {
    // Above the board, looking down, tilted and turned.
    const Rigid board_from_camera =
        Rigid{rotation_from_rpy({std::numbers::pi, 0, 0}), {0.1 * normal(random), 0.1 * normal(random), 0.45}} *
        Rigid{rotation_from_vector<double>(three(0.35)), Vector3::Zero()};
    const Rigid base_from_camera = base_from_board * board_from_camera;
    Observation& o = s.observations.emplace_back();
    o.id = i;
    o.time = i;
    o.position = make_position(base_from_camera * inverse(flange_from_camera));
    const Rigid noise{rotation_from_vector<double>(three(5e-4)), three(3e-4)};
    o.target_pose = noise * inverse(board_from_camera);
  }
  show_poses(s, usual_lever);
  return s;
}

/// The same with poses read otherwise.
template <class Change>
Session with_target_poses(Session s, const Change& change) {
  for (Observation& o : s.observations) o.target_pose = change(*o.target_pose);
  show_poses(s, usual_lever);
  return s;
}
template <class Change>
Session with_flange_poses(Session s, const Change& change) {
  for (Observation& o : s.observations) o.position = make_position(change(base_from_flange(o.position)));
  return s;
}

/// The names of what is found, as a user would see them.
inline std::vector<std::string> blunders_in(const Session& s) {
  const Fit f = fit(s);
  if (!may_be_a_blunder(s, f)) return {};
  std::vector<std::string> names;
  for (const Blunder& b : find_blunders(s, f)) names.push_back(display_name(b));
  return names;
}

}  // namespace handsight::fixture
