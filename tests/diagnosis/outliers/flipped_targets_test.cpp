// SPDX-License-Identifier: Apache-2.0
// Flat tags whose tilt flipped to its mirror image are named, and nothing else is.
#include "diagnosis/outliers/flipped_targets.h"

#include <gmock/gmock.h>

#include <random>

#include "fixtures/drawn.h"
#include "session/pose_points.h"

namespace handsight {
namespace {

constexpr double pi = 3.14159265358979323846;

/// A camera on a flange above a tag on the table; the tag's poses have noise.
Session tag_session(int count) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  const auto drawn = [&](double size) { return Vector3(size * fixture::drawn_3([&] { return normal(random); })); };
  const Rigid flange_from_camera{rotation_from_rpy({0, 0.03, 1.5}), {0.06, -0.03, 0.05}},
      base_from_tag{rotation_from_rpy({0.01, 0.02, 0.5}), {0.55, 0.08, 0.01}};
  Session s;
  s.robot = poses_robot();
  s.joints = joint_names(s.robot);
  s.tcp = "base";
  s.mount = {"flange", Rigid{}, true, false};
  s.pose_sensor = PoseSensor{};
  for (int i = 0; i < count; ++i) {
    const Vector3 turn = drawn(0.3);
    const Rigid flange{rotation_from_rpy({pi + turn.x(), turn.y(), turn.z()}), Vector3(0.55, 0.1, 0.5) + drawn(0.1)};
    Observation& o = s.observations.emplace_back();
    o.id = i;
    o.time = i;
    o.position = make_position(flange);
    o.target_pose = inverse(flange * flange_from_camera) * base_from_tag *
                    Rigid{rotation_from_vector<double>(drawn(0.003)), drawn(3e-4)};
  }
  return s;
}

std::vector<std::int64_t> named_in(Session s) {
  show_poses(s, pose_lever(*s.pose_sensor));
  std::vector<std::int64_t> ids;
  for (const FlippedTarget& f : flipped_targets(s, fit(s))) ids.push_back(f.id);
  return ids;
}

TEST(FlippedTargets, AMirrorIsItsOwnInverseAndNothingFromInFront) {
  const Rigid tilted{rotation_from_rpy({pi + 0.4, 0.2, 1.0}), {0.05, -0.02, 0.5}};
  EXPECT_LT((mirrored_tilt(mirrored_tilt(tilted)).rotation - tilted.rotation).norm(), 1e-12);
  EXPECT_GT((mirrored_tilt(tilted).rotation - tilted.rotation).norm(), 0.5);
  const Rigid in_front{rotation_from_rpy({pi, 0, 1.0}), {0, 0, 0.5}};
  EXPECT_LT((mirrored_tilt(in_front).rotation - in_front.rotation).norm(), 1e-12);
}

TEST(FlippedTargets, AreNamed) {
  Session s = tag_session(20);
  EXPECT_THAT(named_in(s), testing::IsEmpty());
  for (const std::size_t i : {3, 9, 14}) s.observations[i].target_pose = mirrored_tilt(*s.observations[i].target_pose);
  EXPECT_THAT(named_in(s), testing::ElementsAre(3, 9, 14));
}

TEST(FlippedTargets, OtherWrongTurnsAreNotCalledSo) {
  Session s = tag_session(20);
  s.observations[5].target_pose->rotation = s.observations[5].target_pose->rotation * rotation_from_rpy({0, 0, pi / 2});
  EXPECT_THAT(named_in(s), testing::IsEmpty());
}

TEST(FlippedTargets, AreLeftOutOfTheSession) {
  Session s = tag_session(12);
  show_poses(s, pose_lever(*s.pose_sensor));
  s = without_flipped(s, {{4, 4, 0.5, 0.01}});
  EXPECT_FALSE(is_used(s.observations[4]));
  EXPECT_TRUE(is_used(s.observations[5]));
  EXPECT_NE(flipped_text({{4, 4, 0.5, 0.01}}).find("Observation 4"), std::string::npos);
}

}  // namespace
}  // namespace handsight
