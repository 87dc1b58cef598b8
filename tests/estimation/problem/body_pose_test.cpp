// SPDX-License-Identifier: Apache-2.0
#include "estimation/problem/body_pose.h"

#include <gtest/gtest.h>

#include "fixtures/arms.h"
#include "simulation/random.h"

namespace handsight {
namespace {

const std::vector<Vector3> markers_in_body = {{0, 0, 0}, {0.06, 0, 0}, {0.02, 0.05, 0.01}, {0.05, 0.04, -0.01}};
const Rigid first_from_body{rotation_from_rpy({2.9, 0.2, 0.4}), {0.05, -0.04, 0.9}};

std::vector<Sighting> sightings(const Rig& rig, double noise, Random& random, int count = 4) {
  std::vector<Sighting> all;
  for (int m = 0; m < count; ++m) {
    const Vector3 x = first_from_body * markers_in_body[static_cast<std::size_t>(m)];
    const double a = random.gaussian(), b = random.gaussian(), c = random.gaussian(), d = random.gaussian();
    all.push_back(seen_at(m, project(rig.at(0).camera, x) + noise * Vector2(a, b),
                          project(rig.at(1).camera, Vector3(rig.at(1).camera_from_first * x)) + noise * Vector2(c, d)));
  }
  return all;
}

TEST(BodyPose, IsExactWithoutNoiseFromAFarGuess) {
  const Rig rig = *fixture::stand_session().rig;
  Random random(1);
  const auto seen = sightings(rig, 0, random);
  const auto start = body_pose_from_points(&rig, seen, markers_in_body);
  ASSERT_TRUE(start);
  EXPECT_LT(small_motion_between(first_from_body, *start).norm(), 1e-8);
  Vector6 off;
  off << 0.05, -0.03, 0.1, 0.3, -0.2, 0.3;
  const auto pose = estimate_body_pose(&rig, seen, markers_in_body, small_motion<double>(off) * first_from_body);
  ASSERT_TRUE(pose);
  EXPECT_LT(small_motion_between(first_from_body, pose->sensor_from_body).norm(), 1e-9);
}

TEST(BodyPose, CovarianceIsThatOfManyDraws) {
  const Rig rig = *fixture::stand_session().rig;
  Random random(2);
  const double noise = 0.3;
  double sum = 0;
  const int trials = 2000;
  for (int i = 0; i < trials; ++i) {
    const auto pose = estimate_body_pose(&rig, sightings(rig, noise, random), markers_in_body, first_from_body);
    ASSERT_TRUE(pose);
    const Vector6 error = small_motion_between(first_from_body, pose->sensor_from_body);
    sum += error.dot((noise * noise * pose->unit_covariance).inverse() * error) / trials;
  }
  EXPECT_NEAR(sum, 6, 4 * std::sqrt(12.0 / trials));  // chi-squared of 6: variance 12
}

TEST(BodyPose, OneCameraIsEnoughWithAGuess) {
  const Rig rig = *fixture::stand_session().rig;
  Random random(3);
  auto seen = sightings(rig, 0, random);
  for (Sighting& s : seen) forget(s, 1);
  const auto pose =
      estimate_body_pose(&rig, seen, markers_in_body, small_motion<double>(Vector6::Constant(0.01)) * first_from_body);
  ASSERT_TRUE(pose);
  EXPECT_LT(small_motion_between(first_from_body, pose->sensor_from_body).norm(), 1e-7);
}

TEST(BodyPose, NeedsThreeMarkersOffALine) {
  const Rig rig = *fixture::stand_session().rig;
  Random random(4);
  EXPECT_FALSE(estimate_body_pose(&rig, sightings(rig, 0.2, random, 2), markers_in_body, first_from_body));
  const std::vector<Vector3> line = {{0, 0, 0}, {0.03, 0, 0}, {0.06, 0, 0}};
  std::vector<Sighting> on_line;
  for (int m = 0; m < 3; ++m) {
    const Vector3 x = first_from_body * line[static_cast<std::size_t>(m)];
    on_line.push_back(
        seen_at(m, project(rig.at(0).camera, x), project(rig.at(1).camera, Vector3(rig.at(1).camera_from_first * x))));
  }
  EXPECT_FALSE(estimate_body_pose(&rig, on_line, line, first_from_body));
}

}  // namespace
}  // namespace handsight
