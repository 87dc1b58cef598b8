// SPDX-License-Identifier: Apache-2.0
// Sessions from bags whose detectors tell several poses a message.
#include "convert/bag_fixture.h"
#include "convert/convert_fixture.h"
#include "readers/bags/recordings.h"

namespace handsight {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// What one detector saw at one time, written into its message.
using Detection = std::function<void(fixture::MessageWriter&, double time, std::size_t stand, const Rigid& target)>;

class BagPoses : public Convert {
 protected:
  const Rigid tcp_from_target{rotation_from_rpy({0.3, -0.2, 0.9}), {0.02, 0.05, 0.1}},
      aside{Matrix3::Identity(), {0.3, 0, 1}};

  struct Detector {
    std::string topic, package, type;
    Detection write;
  };

  /// The arm stands for a second of two in each pose, before these detectors.
  std::filesystem::path record(const std::vector<Detector>& detectors, bool ros1) {
    const std::vector<Rigid> targets = target_poses(truth, tcp_from_target);
    fixture::Recording r;
    r.ros1 = ros1;
    r.topics = {{"/joint_states", "sensor_msgs", "JointState"}};
    for (const Detector& d : detectors) r.topics.push_back({d.topic, d.package, d.type});
    for (std::size_t i = 0; i < targets.size(); ++i)
      for (int k = 0; k < 50; ++k) {
        const double t = 1000 + 2.0 * static_cast<double>(i) + 0.02 * k;
        const Eigen::VectorXd& q = truth.session.observations[i].position;
        const auto nanoseconds = static_cast<std::int64_t>(1e9 * t);
        fixture::MessageWriter joints(ros1);
        joints.header(t, "").count(6);
        for (const char* name : {"a1", "a2", "a3", "a4", "a5", "a6"}) joints.text(name);
        joints.list({q.data(), q.data() + 6}).list({}).list({});
        r.messages.push_back({0, nanoseconds, joints.bytes()});
        for (std::size_t d = 0; k % 3 == 0 && d < detectors.size(); ++d) {
          fixture::MessageWriter seen(ros1);
          detectors[d].write(seen, t, i, targets[i]);
          r.messages.push_back({static_cast<int>(d) + 1, nanoseconds, seen.bytes()});
        }
      }
    const auto file = folder.path / (ros1 ? "take.bag" : "take.mcap");
    fixture::write_file(file, ros1 ? fixture::ros1_bag_of(r, "lz4") : fixture::mcap_of(r, {"zstd"}));
    return file;
  }

  void expect_right(const Conversion& c) {
    ASSERT_GE(c.session.observations.size(), 5u);
    const Fit f = fit(c.session);
    EXPECT_LT(f.residual_rms, 1e-5);
    EXPECT_LT(small_motion_between(tcp_from_target, f.tcp_from_body).norm(), 1e-5);
  }

  static void write_poses(fixture::MessageWriter& w, const std::vector<Rigid>& poses) {
    w.count(poses.size());
    for (const Rigid& pose : poses) w.fixed(fixture::list_numbers(pose));
  }

  /// A PoseArray of the target, unseen in every fourth stand, and of what else is given.
  Detector array_of(std::vector<Rigid> others, bool always_all = true) {
    return {"/aruco_poses", "geometry_msgs", "PoseArray",
            [=](fixture::MessageWriter& w, double t, std::size_t stand, const Rigid& target) {
              std::vector<Rigid> poses = others;
              poses.push_back(target);
              if (stand % 4 == 3) poses.clear();
              if (!always_all && stand % 2 == 0 && poses.size() > 1) poses.pop_back();
              w.header(t, "camera");
              write_poses(w, poses);
            }};
  }
  /// ros2_aruco's message of two tags.
  Detector numbered_tags() {
    return {"/aruco_markers", "ros2_aruco_interfaces", "ArucoMarkers",
            [this](fixture::MessageWriter& w, double t, std::size_t stand, const Rigid& target) {
              w.header(t, "camera").count(2);
              const bool is_first = stand % 2 == 0;  // the order of what is found first
              w.number(std::int64_t{is_first ? 7 : 12}).number(std::int64_t{is_first ? 12 : 7});
              write_poses(w, is_first ? std::vector{target, aside} : std::vector{aside, target});
            }};
  }
};

TEST_F(BagPoses, TheOnlyPoseOfAnArrayIsTheTarget) {
  for (const bool ros1 : {false, true}) expect_right(converted({record({array_of({})}, ros1)}));
}

TEST_F(BagPoses, OneOfSeveralOfAnArrayMustBeAskedFor) {
  const auto bag = record({array_of({aside})}, false);
  EXPECT_THAT(refusal({bag}), HasSubstr("/aruco_poses[0] /aruco_poses[1]"));
  options_.target_frame = "/aruco_poses[1]";
  const Conversion c = converted({bag});
  expect_right(c);
  EXPECT_THAT(c.notes, Contains(HasSubstr("as if their order were the same in every message")));
}

TEST_F(BagPoses, OfArraysOfNowTwoAndNowOneNothingTellsWhichIsWhich) {
  const std::string said = refusal({record({array_of({aside}, false)}, false)});
  EXPECT_THAT(said, HasSubstr("holds 1 to 2 poses a message"));
  EXPECT_THAT(said, HasSubstr("Record a topic that names them"));
}

TEST_F(BagPoses, TagsWithNumbersAreFramesWhateverTheirOrder) {
  options_.target_frame = "/aruco_markers/7";
  for (const bool ros1 : {false, true}) expect_right(converted({record({numbered_tags()}, ros1)}));
}

TEST_F(BagPoses, TagsAndBoardsOfADetectionAreFrames) {
  const Detector detector{"/aruco_detections", "aruco_opencv_msgs", "ArucoDetection",
                          [this](fixture::MessageWriter& w, double t, std::size_t, const Rigid& target) {
                            w.header(t, "camera").count(1).number(std::uint16_t{3});
                            w.fixed(fixture::list_numbers(aside)).count(1).text("plate");
                            w.fixed(fixture::list_numbers(target));
                          }};
  options_.target_frame = "/aruco_detections/plate";
  for (const bool ros1 : {false, true}) expect_right(converted({record({detector}, ros1)}));
}

/// Detectors publish the same in several ways: /tf, an array, numbers.
TEST_F(BagPoses, WhatAnotherTopicTellsIsNoSecondTarget) {
  const Detector pose{"/aruco_single/pose", "geometry_msgs", "PoseWithCovarianceStamped",
                      [](fixture::MessageWriter& w, double t, std::size_t, const Rigid& target) {
                        w.header(t, "camera").fixed(fixture::list_numbers(target)).fixed(std::vector<double>(36, 0.0));
                      }};
  expect_right(converted({record({pose, array_of({})}, false)}));
}

TEST_F(BagPoses, DamagedOnesAreRefused) {
  const Detector cut{
      "/aruco_poses", "geometry_msgs", "PoseArray",
      [](fixture::MessageWriter& w, double t, std::size_t, const Rigid&) { w.header(t, "camera").count(1000); }};
  EXPECT_THAT(refusal({record({cut}, false)}), HasSubstr("a list is longer than the message"));
}

}  // namespace
}  // namespace handsight
