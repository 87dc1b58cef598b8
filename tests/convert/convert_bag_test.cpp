// SPDX-License-Identifier: Apache-2.0
// Sessions from bags of ROS 2.
#include <limits>

#include "convert/bag_fixture.h"
#include "convert/convert_fixture.h"
#include "readers/bags/recordings.h"

namespace handsight {
namespace {

using testing::Contains;
using testing::HasSubstr;

TEST_F(Convert, BagsWithTransformsArePairedByTimeWhereTheRobotStands) {
  const Rigid tcp_from_target{rotation_from_rpy({0.3, -0.2, 0.9}), {0.02, 0.05, 0.1}};
  const std::vector<Rigid> targets = target_poses(truth, tcp_from_target);
  const Chain chain = make_chain(truth.session);
  constexpr double start = 1.7e9, lag = 0.08;
  {
    fixture::BagWriter bag(folder.path / "bag");
    const int joints = bag.topic("/joint_states", "sensor_msgs/msg/JointState"),
              tf = bag.topic("/tf", "tf2_msgs/msg/TFMessage"), log = bag.topic("/rosout", "rcl_interfaces/msg/Log");
    bag.message(log, start, "nothing");
    const auto& observations = truth.session.observations;
    std::vector<std::pair<double, Eigen::VectorXd>> way;  // 1 s of way, 1 s of standing
    for (double t = 0; t < 2.0 * 20; t += 0.02) {
      const auto k = static_cast<std::size_t>(t / 2);
      const double share = std::min(1.0, t - 2 * static_cast<double>(k));
      const Eigen::VectorXd q =
          observations[k].position + share * (observations[k + 1].position - observations[k].position);
      // Two publishers: the wrist's joints come from another node, in another order.
      bag.message(joints, start + t,
                  fixture::joint_state(start + t, {"a3", "a2", "a1", "gripper"}, {q[2], q[1], q[0], 0.5}));
      bag.message(joints, start + t, fixture::joint_state(start + t, {"a4", "a5", "a6"}, {q[3], q[4], q[5]}, true));
      way.emplace_back(start + t, q);
    }
    for (std::size_t i = 0; i < way.size(); i += 3) {
      const Rigid pose = sensor_from_tcp(chain_ends(chain, way[i].second), truth.mount_from_sensor) * tcp_from_target;
      bag.message(tf, way[i].first + lag, fixture::transform(way[i].first + lag, "camera", "tag_7", pose));
      bag.message(tf, way[i].first + lag, fixture::transform(way[i].first + lag, "base", "camera_link", Rigid{}));
    }
  }
  options_.estimate_lag = true;
  const Conversion c = converted({folder.path / "bag"});
  EXPECT_THAT(c.notes, Contains(HasSubstr("0.08")));
  EXPECT_THAT(c.notes, Contains(HasSubstr("the robot was moving")));
  EXPECT_THAT(c.notes, Contains(HasSubstr("/rosout")));
  EXPECT_THAT(c.notes, Contains(HasSubstr("1 joints that were published")));
  ASSERT_GE(c.session.observations.size(), 18u);
  ASSERT_LE(c.session.observations.size(), 21u);
  const Fit f = fit(c.session);
  EXPECT_LT(f.residual_rms, 1e-5);
  EXPECT_LT(small_motion_between(tcp_from_target, f.tcp_from_body).norm(), 1e-5);
}

/// Twelve stands of an arm, 1 s each with a second of way between, of which /tf tells the flange through two frames.
void write_bag_of_poses(const std::filesystem::path& folder, const Rigid& flange_from_camera,
                        const Rigid& base_from_tag) {
  fixture::BagWriter bag(folder);
  const int tf = bag.topic("/tf", "tf2_msgs/msg/TFMessage"), fixed = bag.topic("/tf_static", "tf2_msgs/msg/TFMessage");
  const Rigid wrist_from_flange{rotation_from_rpy({0, 0, 0.5}), {0, 0, 0.1}};
  bag.message(fixed, 99, fixture::transform(99, "wrist", "tool0", wrist_from_flange));
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  const auto drawn = [&] {
    // The tool looks down: its roll is about pi, and jumps between pi and -pi where it shakes.
    const Vector3 turn{M_PI + 0.3 * normal(random), 0.3 * normal(random), normal(random)};
    return Rigid{rotation_from_rpy(turn),
                 Vector3(0.4, 0, 0.5) + 0.1 * Vector3(normal(random), normal(random), normal(random))};
  };
  Rigid from = drawn(), to = drawn();
  for (int i = 0; i < 12; ++i, from = to, to = drawn())
    for (double s = 0; s < 2; s += 0.02) {
      const double t = 100 + 2 * i + s, share = std::max(0.0, s - 1);
      const Rigid flange = from * small_motion<double>(share * small_motion_between(from, to));
      bag.message(tf, t, fixture::transform(t, "base_link", "wrist", flange * inverse(wrist_from_flange)));
      if (std::abs(s - 0.6) > 0.005) continue;
      bag.message(
          tf, t,
          fixture::transform(t, "camera_optical", "tag_7", inverse(flange * flange_from_camera) * base_from_tag));
    }
}

TEST_F(Convert, BagsWithoutARobotAreHandEyePoses) {
  const Rigid flange_from_camera{rotation_from_rpy({0.02, -0.05, 1.5}), {0.06, -0.03, 0.05}},
      base_from_tag{rotation_from_rpy({0.03, 0.02, 0.5}), {0.55, 0.08, 0.01}};
  write_bag_of_poses(folder.path / "bag", flange_from_camera, base_from_tag);
  options_.tcp.clear(), options_.mount.clear();
  const std::vector<std::filesystem::path> files{folder.path / "bag"};
  const Conversion c = convert(files, options_);
  EXPECT_THAT(c.notes, Contains(HasSubstr("The flange is the frame \"tool0\" that /tf gives in \"base_link\"")));
  ASSERT_EQ(c.session.observations.size(), 12u);
  const Fit f = fit(c.session);
  EXPECT_LT(small_motion_between(flange_from_camera, estimate(f).mount_from_sensor).norm(), 1e-6);
}

TEST_F(Convert, BagsWithoutARobotSayWhatTheFlangeCouldBe) {
  {
    fixture::BagWriter bag(folder.path / "bag");
    const int tf = bag.topic("/tf", "tf2_msgs/msg/TFMessage");
    bag.message(tf, 1, fixture::transform(1, "base", "elbow", Rigid{}));
  }
  options_.tcp.clear();
  const std::vector<std::filesystem::path> files{folder.path / "bag"};
  const auto refusal = [&] {
    try {
      convert(files, options_);
    } catch (const InputError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_THAT(refusal(), testing::AllOf(HasSubstr("--tcp"), HasSubstr("elbow")));
  options_.tcp = "hand";
  EXPECT_THAT(refusal(), HasSubstr("no such frame"));
  options_.tcp = "elbow";
  EXPECT_THAT(refusal(), HasSubstr("record /tf while the robot moves"));
}

/// Four images of the left camera and three of the right; the robot stands before each.
void write_stereo_bag(const std::filesystem::path& folder) {
  const Camera camera = fixture::small_camera();
  fixture::BagWriter bag(folder);
  const int joints = bag.topic("/joint_states", "sensor_msgs/msg/JointState"),
            left = bag.topic("/stereo/left/image_raw", "sensor_msgs/msg/Image"),
            right = bag.topic("/stereo/right/image_raw", "sensor_msgs/msg/Image"),
            left_info = bag.topic("/stereo/left/camera_info", "sensor_msgs/msg/CameraInfo"),
            right_info = bag.topic("/stereo/right/camera_info", "sensor_msgs/msg/CameraInfo");
  bag.message(left_info, 0, fixture::camera_info(camera, Matrix3::Identity(), 0));
  bag.message(right_info, 0, fixture::camera_info(camera, rotation_from_rpy({0, 0.1, 0}), -800 * 0.12));
  for (int i = 0; i < 4; ++i) {
    const double t = 100 + 2 * i;
    for (double s = 0; s < 1.5; s += 0.02)
      bag.message(
          joints, t + s,
          fixture::joint_state(t + s, {"a1", "a2", "a3", "a4", "a5", "a6"}, {0.1 * i, 0.2, 0.3, 0.4, 0.5, 0.6}));
    bag.message(left, t + 0.5, fixture::small_image(t + 0.5, "mono8", 8));
    if (i != 2) bag.message(right, t + 0.503, fixture::small_image(t + 0.503, "rgb8", 24));
  }
}

TEST_F(Convert, BagsWithImagesOfTwoCameras) {
  write_stereo_bag(folder.path / "bag");
  const Conversion c = converted({folder.path / "bag"});
  ASSERT_EQ(c.session.observations.size(), 3u);
  EXPECT_THAT(c.notes, Contains(HasSubstr("1 of 4 left images have no right image")));
  ASSERT_TRUE(c.session.rig);
  EXPECT_NEAR(c.session.rig->at(1).camera_from_first.translation.norm(), 0.12, 1e-12);
  EXPECT_EQ(c.session.rig->at(0).camera.k1, -0.1);
  EXPECT_NEAR(c.session.observations[2].time, 6, 1e-6);
  EXPECT_NEAR(c.session.observations[2].position[0], 0.3, 1e-12);
  EXPECT_TRUE(std::filesystem::exists(options_.out / c.session.observations[1].images[0]));
  EXPECT_TRUE(c.session.observations[1].images[1].ends_with(".ppm"));
}

TEST_F(Convert, WhereItIsStoppedNothingOfItStays) {
  write_stereo_bag(folder.path / "bag");
  int asked = 0, most = std::numeric_limits<int>::max();
  options_.goes_on = [&] { return asked++ < most; };
  const std::vector<std::filesystem::path> files = {folder.path / "bag", folder.path / "robot.urdf"};
  convert(files, options_);
  const int all = asked;
  ASSERT_GT(all, 300) << "at every message, and at every image again";
  std::filesystem::remove_all(options_.out);
  for (const bool is_there : {false, true}) {
    if (is_there) write("made/notes.txt", "mine");
    for (most = 0; most < all; most += most < all - 12 ? 61 : 1) {
      asked = 0;
      EXPECT_THROW(convert(files, options_), ConversionStopped) << most;
      EXPECT_EQ(std::filesystem::exists(options_.out), is_there) << most;
      if (!is_there) continue;
      EXPECT_EQ(std::distance(std::filesystem::directory_iterator(options_.out), {}), 1) << most;
    }
  }
}

TEST_F(Convert, DamagedBagsAreRefused) {
  {
    fixture::BagWriter bag(folder.path / "bag");
    const int joints = bag.topic("/joint_states", "sensor_msgs/msg/JointState");
    std::string message = fixture::joint_state(1, {"a1", "a2"}, {0.1, 0.2});
    bag.message(joints, 1, message.substr(0, message.size() / 2));
  }
  EXPECT_THAT(refusal({folder.path / "bag"}), HasSubstr("bag is damaged"));
  EXPECT_THAT(refusal({write("no.db3", "SQLite format 3 it is not")}), HasSubstr("no ROS 2 bag"));
  EXPECT_THAT(refusal({write("a.mcap", "\x89MCAP0\r\n")}), HasSubstr("holds no channel"));
}

/// The same recording in MCAP and as a bag of ROS 1 comes to the same session, and a cut copy to the beginning of it.
TEST_F(Convert, McapAndRos1BagsComeToTheSameSession) {
  const Rigid tcp_from_target{rotation_from_rpy({0.3, -0.2, 0.9}), {0.02, 0.05, 0.1}};
  const std::vector<Rigid> targets = target_poses(truth, tcp_from_target);
  const auto recording = [&](bool ros1) {
    fixture::Recording r;
    r.ros1 = ros1;
    r.topics = {{"/joint_states", "sensor_msgs", "JointState"}, {"/aruco_single/pose", "geometry_msgs", "PoseStamped"}};
    for (std::size_t i = 0; i < targets.size(); ++i)
      for (int k = 0; k < 50; ++k) {  // it stands for a second
        const double t = 1000 + 2.0 * static_cast<double>(i) + 0.02 * k;
        const Eigen::VectorXd& q = truth.session.observations[i].position;
        fixture::MessageWriter joints(ros1), pose(ros1);
        joints.header(t, "").count(6);
        for (const char* name : {"a1", "a2", "a3", "a4", "a5", "a6"}) joints.text(name);
        joints.list({q.data(), q.data() + 6}).list({}).list({});
        pose.header(t, "camera").fixed(fixture::list_numbers(targets[i]));
        const auto nanoseconds = static_cast<std::int64_t>(1e9 * t);
        r.messages.push_back({0, nanoseconds, joints.bytes()});
        if (k % 3 == 0) r.messages.push_back({1, nanoseconds, pose.bytes()});
      }
    return r;
  };
  const std::string mcap = fixture::mcap_of(recording(false), {"zstd"});
  fixture::write_file(folder.path / "take" / "take_0.mcap", mcap);
  fixture::write_file(folder.path / "old.bag", fixture::ros1_bag_of(recording(true), "lz4"));
  for (const auto& bag : {folder.path / "take", folder.path / "old.bag"}) {
    const Conversion c = converted({bag});
    ASSERT_EQ(c.session.observations.size(), targets.size());
    const Fit f = fit(c.session);
    EXPECT_LT(f.residual_rms, 1e-5);
    EXPECT_LT(small_motion_between(tcp_from_target, f.tcp_from_body).norm(), 1e-5);
    EXPECT_THAT(c.took, Contains(HasSubstr("a bag of ROS")));
  }
  fixture::write_file(folder.path / "cut.mcap", mcap.substr(0, mcap.size() / 2));
  const Conversion cut = converted({folder.path / "cut.mcap"});
  EXPECT_GE(cut.session.observations.size(), targets.size() / 3);
  EXPECT_LT(cut.session.observations.size(), targets.size());
  EXPECT_THAT(cut.notes, Contains(HasSubstr("the rest is lost")));
  EXPECT_LT(fit(cut.session).residual_rms, 1e-5);
}

}  // namespace
}  // namespace handsight
