// SPDX-License-Identifier: Apache-2.0
// What a session does not determine is no number in a file.
#include "export/reported_motion.h"

#include <gmock/gmock.h>

#include <opencv2/core.hpp>

#include "export/exported.h"
#include "fixtures/exported_robots.h"

namespace handsight {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Turned about z alone: nothing is known of the sensor's place along z, 10 m is what stands for that.
CalibratedRobot robot_without_z(Matrix6 covariance = 1e-8 * Matrix6::Identity()) {
  std::mt19937_64 random(9);
  CalibratedRobot robot = fixture::robot_with(fixture::stand_session(), {}, random);
  covariance(2, 2) = 100;
  robot.calibration.mount_from_sensor = EstimatedMotion{*robot.model.mount_from_sensor, covariance};
  robot.calibration.tcp_from_body.covariance = 1e-8 * Matrix6::Identity();
  return robot;
}

TEST(ReportedMotion, WhatIsKnownIsToldAndNothingElse) {
  const CalibratedRobot robot = robot_without_z();
  const ReportedMotion mount = reported_mount(robot, *robot.model.mount_from_sensor), body = reported_body(robot);
  EXPECT_TRUE(std::isnan(mount.place.z()) && std::isnan(mount.covariance(2, 2)) && std::isnan(mount.covariance(2, 4)));
  EXPECT_EQ(mount.place.x(), robot.model.mount_from_sensor->translation.x());
  EXPECT_EQ(mount.covariance(0, 0), 1e-8);
  EXPECT_TRUE(mount.is_rotation && !mount.is_place && body.is_whole());
}

TEST(ReportedMotion, FilesSayNanAndASentence) {
  const CalibratedRobot robot = robot_without_z();
  const auto of = [&](const char* kind) { return exported_file(robot, kind); };
  for (const char* kind : {"csv", "yaml", "opencv", "static_tf"}) {
    ASSERT_EQ(of(kind).notes.size(), 1U) << kind;
    EXPECT_THAT(of(kind).notes[0], HasSubstr("do not determine z of mount_from_sensor"));
  }
  EXPECT_THAT(of("csv").text, HasSubstr("mount_from_sensor,stand,z,nan,,m"));
  EXPECT_THAT(of("yaml").text, HasSubstr("# The measurements do not determine z of mount_from_sensor"));
  EXPECT_THAT(of("yaml").text, HasSubstr(".nan]"));
  EXPECT_THAT(of("static_tf").text, Not(HasSubstr("handsight_sensor")));
  EXPECT_THAT(of("static_tf").text, HasSubstr("the transform is left out"));
  const cv::FileStorage storage(of("opencv").text, cv::FileStorage::READ | cv::FileStorage::MEMORY);
  cv::Mat mount;
  storage["mount_from_sensor"] >> mount;
  ASSERT_EQ(mount.rows, 4);
  EXPECT_TRUE(std::isnan(mount.at<double>(2, 3)));
  EXPECT_EQ(mount.at<double>(0, 3), robot.model.mount_from_sensor->translation.x());
}

TEST(ReportedMotion, ATurnThatNothingTellsIsNoRotation) {
  CalibratedRobot robot = robot_without_z();
  robot.calibration.mount_from_sensor->covariance = 1e-8 * Matrix6::Identity();
  robot.calibration.mount_from_sensor->covariance(5, 5) = 9;
  const ReportedMotion mount = reported_mount(robot, *robot.model.mount_from_sensor);
  EXPECT_TRUE(mount.rotation.hasNaN() && !mount.is_rotation);
  EXPECT_THAT(exported_file(robot, "csv").text, HasSubstr("mount_from_sensor,stand,qw,nan,,1"));
}

/// The turn of a body with one marker is a convention: it stays, without a sigma.
TEST(ReportedMotion, OneMarkersTurnIsAConvention) {
  CalibratedRobot robot = robot_without_z();
  robot.calibration.markers = {Vector3::Zero()};
  robot.calibration.unseen_markers.clear();
  robot.calibration.tcp_from_body = {robot.model.tcp_from_body, 1e-8 * Matrix6::Identity()};
  robot.calibration.tcp_from_body.covariance.bottomRightCorner<3, 3>() = 9 * Matrix3::Identity();
  robot.calibration.tcp_from_body.motion.translation.setZero();
  const ReportedMotion body = reported_body(robot);
  EXPECT_TRUE(body.is_rotation && !body.rotation.hasNaN() && std::isnan(body.covariance(4, 4)));
}

}  // namespace
}  // namespace handsight
