// SPDX-License-Identifier: Apache-2.0
// Sessions from what users have: recognised by content, wrong units and orders found and said, the same calibration at
// the end.
#include "ways/convert.h"

#include <gmock/gmock.h>

#include "estimation/fit.h"
#include "session/session_xml.h"
#include "ways/bag_fixture.h"
#include "ways/robot_texts.h"
#include "ways/ways_fixtures.h"

namespace handsight {
namespace {

using testing::AnyOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// A tracker session with known truth, whose parts are then written as other programs write them.
class Convert : public testing::Test {
 protected:
  Convert() {
    SimulationOptions options;
    options.observations = 40;
    options.seed = 5;
    truth = simulate_session(fixture::tracker_session(4), options);
    write("robot.urdf", fixture::urdf_text(truth.session.robot));
    options_.tcp = "hand";
    options_.mount = "stand";
    options_.out = folder.path / "made";
  }

  std::filesystem::path write(const std::string& name, const std::string& text) {
    std::filesystem::create_directories((folder.path / name).parent_path());
    std::ofstream(folder.path / name) << text;
    return folder.path / name;
  }

  /// A table of joint readings; `unit` of each number.
  std::string joints_csv(double unit = 1, const std::string& header = "time,a1,a2,a3,a4,a5,a6", bool with_time = true) {
    std::string text = header.empty() ? "" : header + "\n";
    for (std::size_t i = 0; i < truth.session.observations.size(); ++i) {
      if (with_time) text += fmt::format("{},", 10.0 * static_cast<double>(i));
      const Eigen::VectorXd& q = truth.session.observations[i].position;
      for (Eigen::Index j = 0; j < 6; ++j) text += fmt::format("{}{}", j ? "," : "", q[j] * unit);
      text += "\n";
    }
    return text;
  }

  std::string points_csv(double unit = 1) {
    std::string text = "time";
    for (int m = 0; m < 4; ++m) text += fmt::format(",m{0}_x,m{0}_y,m{0}_z", m);
    for (std::size_t i = 0; i < truth.session.observations.size(); ++i) {
      text += fmt::format("\n{}", 10.0 * static_cast<double>(i));
      for (const Sighting& s : truth.session.observations[i].sightings)
        text += fmt::format(",{},{},{}", s.point->x() * unit, s.point->y() * unit, s.point->z() * unit);
    }
    return text + "\n";
  }

  Conversion converted(const std::vector<std::filesystem::path>& files) {
    std::filesystem::remove_all(options_.out);
    std::vector<std::filesystem::path> all = files;
    all.push_back(folder.path / "robot.urdf");
    return convert(all, options_);
  }

  std::string refusal(const std::vector<std::filesystem::path>& files) {
    try {
      converted(files);
    } catch (const InputError& error) {
      EXPECT_GE(std::string(error.what()).size(), 20u);
      EXPECT_LE(std::string(error.what()).size(), 600u);
      return error.what();
    }
    return "no refusal";
  }

  /// The converted session fits to the device's noise, with the same body.
  void expect_good(const Session& session) {
    ASSERT_EQ(session.observations.size(), truth.session.observations.size());
    const Fit f = fit(session);
    EXPECT_TRUE(f.converged());
    EXPECT_LT(f.residual_rms, 3e-4);  // m; 0.2 mm of noise
    EXPECT_EQ(read_session(options_.out).observations.size(), session.observations.size());
  }

  SimulatedSession truth;
  TemporaryFolder folder;
  ConvertOptions options_;
};

TEST_F(Convert, JointAndPointTablesOfATracker) {
  const Conversion c = converted({write("j.csv", joints_csv()), write("p.csv", points_csv())});
  expect_good(c.session);
  EXPECT_THAT(c.took, Contains(HasSubstr("j.csv: a table of joint readings")));
  EXPECT_THAT(c.took, Contains(HasSubstr("p.csv: a table of points")));
}

TEST_F(Convert, DegreesAndMillimetresAreFoundAndSaid) {
  constexpr double degrees = 180 / 3.14159265358979323846;
  const auto points = write("p.csv", points_csv(1000));
  EXPECT_THAT(refusal({write("j.csv", joints_csv(degrees)), points}), HasSubstr("--degrees"));
  const Conversion by_header = converted(
      {write("j.csv", joints_csv(degrees, "time,a1 [deg],a2 [deg],a3 [deg],a4 [deg],a5 [deg],a6 [deg]")), points});
  expect_good(by_header.session);
  EXPECT_THAT(by_header.notes, Contains(HasSubstr("read as degrees")));
  EXPECT_THAT(by_header.notes, Contains(HasSubstr("taken for millimetres")));
  options_.degrees = true;
  expect_good(converted({write("j.csv", joints_csv(degrees)), points}).session);
}

TEST_F(Convert, ColumnsGoByNameAndAWrongOrderIsSaid) {
  std::string text = "a6;a5;a4;a3;a2;a1\n";  // another order, another separator, decimal commas
  for (const Observation& o : truth.session.observations) {
    std::string line;
    for (Eigen::Index j = 5; j >= 0; --j) line += fmt::format("{:.17g}{}", o.position[j], j ? ";" : "\n");
    std::replace(line.begin(), line.end(), '.', ',');
    text += line;
  }
  const auto points = write("p.csv", points_csv());
  const Conversion c = converted({write("j.csv", text), points});
  expect_good(c.session);
  EXPECT_THAT(c.notes, Contains(HasSubstr("decimal points")));
  // Without a header nothing says the order but the limits: a2 may turn 2.0 rad, a1 2.6.
  for (Observation& o : truth.session.observations) std::swap(o.position[0], o.position[1]);
  truth.session.observations[3].position[1] = 2.5;
  const Conversion swapped = converted({write("k.csv", joints_csv(1, "", false)), points});
  EXPECT_THAT(swapped.notes, Contains(HasSubstr("columns in another order")));
  EXPECT_THAT(swapped.notes, Contains(HasSubstr("With a1 and a2 exchanged")));
}

TEST_F(Convert, MissingJointsAreSaid) {
  std::string text = "a1,a2,a3,a5,a6\n";
  for (const Observation& o : truth.session.observations)
    text += fmt::format("{},{},{},{},{}\n", o.position[0], o.position[1], o.position[2], o.position[4], o.position[5]);
  const Conversion c = converted({write("j.csv", text), write("p.csv", points_csv())});
  EXPECT_THAT(c.notes, Contains(AllOf(HasSubstr("a4"), HasSubstr("taken to stand at 0"))));
}

TEST_F(Convert, TimesThatDoNotPairAreSaid) {
  const auto points = write("p.csv", points_csv());
  std::string early = "time,a1,a2,a3,a4,a5,a6\n";
  for (int i = 0; i < 100; ++i) early += fmt::format("{},0,0,0,0,0,0\n", -1000 + i * 0.1);
  EXPECT_THAT(refusal({write("j.csv", early), points}), AllOf(HasSubstr("None of the 40"), HasSubstr("clocks")));
  std::string untimed = "a1,a2,a3,a4,a5,a6\n0,0,0,0,0,0\n0,0,0,0,0,1\n";
  EXPECT_THAT(refusal({write("j.csv", untimed), points}), HasSubstr("no times to pair them by"));
}

TEST_F(Convert, LinesOutOfOrderAreSorted) {
  std::istringstream lines(joints_csv());
  std::vector<std::string> all;
  for (std::string line; std::getline(lines, line);) all.push_back(line);
  std::swap(all[3], all[20]);
  std::string text;
  for (const std::string& line : all) text += line + "\n";
  const Conversion c = converted({write("j.csv", text), write("p.csv", points_csv())});
  expect_good(c.session);
  EXPECT_THAT(c.notes, Contains(HasSubstr("they were sorted")));
}

TEST_F(Convert, ALineAPointAndUnseenPoints) {
  std::string text = "observation,marker,x,y,z\n";
  for (std::size_t i = 0; i < truth.session.observations.size(); ++i)
    for (const Sighting& s : truth.session.observations[i].sightings)
      text += i == 4 && s.marker == 2
                  ? fmt::format("{},{},,,\n", i, s.marker + 7)
                  : fmt::format("{},{},{},{},{}\n", i, s.marker + 7, s.point->x(), s.point->y(), s.point->z());
  const Conversion c = converted({write("j.csv", joints_csv(1, "a1,a2,a3,a4,a5,a6", false)), write("p.csv", text)});
  expect_good(c.session);
  EXPECT_EQ(c.session.observations[4].sightings.size(), 3u);
  EXPECT_THAT(c.notes, Contains(HasSubstr("1 points were not seen")));
}

/// The body's pose in the tracker's frame, as mocap gives a rigid body.
std::vector<Rigid> target_poses(const SimulatedSession& truth, const Rigid& tcp_from_target) {
  std::vector<Rigid> poses;
  const Chain chain = chain_of(truth.session);
  for (const Observation& o : truth.session.observations)
    poses.push_back(sensor_from_tcp(chain_ends(chain, o.position), truth.mount_from_sensor) * tcp_from_target);
  return poses;
}

std::string pose_line(const Rigid& pose, const char* between = ",") {
  const Eigen::Quaterniond q(pose.rotation);
  const Vector3& t = pose.translation;
  return fmt::format("{1}{0}{2}{0}{3}{0}{4}{0}{5}{0}{6}{0}{7}", between, t.x(), t.y(), t.z(), q.x(), q.y(), q.z(),
                     q.w());
}

TEST_F(Convert, PosesOfATargetBecomeFourPoints) {
  const Rigid tcp_from_target{rotation_from_rpy({0.3, -0.2, 0.9}), {0.02, 0.05, 0.1}};
  std::string csv = "x,y,z,qx,qy,qz,qw\n", tum = "# a trajectory\n", yaml = "poses:\n";
  int i = 0;
  for (const Rigid& pose : target_poses(truth, tcp_from_target)) {
    csv += pose_line(pose) + "\n";
    tum += fmt::format("{} {}\n", 10.0 * i++, pose_line(pose, " "));
    const Eigen::Quaterniond q(pose.rotation);
    yaml += fmt::format("- position: {{x: {}, y: {}, z: {}}}\n  orientation: {{x: {}, y: {}, z: {}, w: {}}}\n",
                        pose.translation.x(), pose.translation.y(), pose.translation.z(), q.x(), q.y(), q.z(), q.w());
  }
  for (const auto& [name, text] :
       {std::pair("target.csv", csv), std::pair("target.txt", tum), std::pair("t.yaml", yaml)}) {
    const Conversion c = converted({write("j.csv", joints_csv()), write(name, text)});
    EXPECT_THAT(c.notes, Contains(HasSubstr("four points of a tracker"))) << name;
    const Fit f = fit(c.session);
    EXPECT_LT(f.residual_rms, 1e-7) << name;
    // Markers 0 and 1 lie on the target's x axis: its pose in the TCP frame follows.
    const Vector3 along = (estimate(f).markers_in_tcp[1] - estimate(f).markers_in_tcp[0]) / 0.1;
    EXPECT_LT((along - tcp_from_target.rotation.col(0)).norm(), 1e-6) << name;
    EXPECT_LT((estimate(f).markers_in_tcp[0] - tcp_from_target.translation).norm(), 1e-7) << name;
  }
}

/// Samples as easy_handeye2 writes them, with the camera on the hand or on a stand.
std::string samples_text(const std::string& kind, const std::vector<Rigid>& robot, const std::vector<Rigid>& tracking) {
  const auto pose = [](const Rigid& m) {
    const Eigen::Quaterniond q(m.rotation);
    return fmt::format(
        "    translation:\n      x: {}\n      y: {}\n      z: {}\n    rotation:\n      x: {}\n      y: {}\n "
        "     z: {}\n      w: {}\n",
        m.translation.x(), m.translation.y(), m.translation.z(), q.x(), q.y(), q.z(), q.w());
  };
  std::string text = "parameters:\n  name: ''\n  calibration_type: '" + kind + "'\nsamples:\n";
  for (std::size_t i = 0; i < robot.size(); ++i)
    text += "- robot:\n" + pose(robot[i]) + "  tracking:\n" + pose(tracking[i]);
  return text;
}

TEST_F(Convert, EasyHandEyeSamplesOfBothKinds) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const Rigid hand_from_camera{rotation_from_rpy({0.1, 0.2, -1.0}), {0.05, 0.01, 0.08}},
      base_from_target{rotation_from_rpy({3.0, 0.1, 0.5}), {0.6, 0.1, 0.02}},
      base_from_camera{rotation_from_rpy({-2.0, 0.0, 1.2}), {1.2, -0.3, 0.7}},
      hand_from_target{rotation_from_rpy({0.2, 0.1, 0.3}), {0.0, 0.03, 0.1}};
  std::vector<Rigid> base_from_hand;
  for (int i = 0; i < 20; ++i)
    base_from_hand.push_back(
        {rotation_from_rpy({uniform(random), uniform(random), uniform(random)}),
         Vector3(0.5 + 0.2 * uniform(random), 0.3 * uniform(random), 0.5 + 0.2 * uniform(random))});
  options_.tcp.clear();
  options_.mount.clear();
  for (const bool in_hand : {true, false}) {
    std::vector<Rigid> robot, tracking;
    for (const Rigid& hand : base_from_hand) {
      robot.push_back(in_hand ? hand : inverse(hand));
      tracking.push_back(in_hand ? inverse(hand * hand_from_camera) * base_from_target
                                 : inverse(base_from_camera) * hand * hand_from_target);
    }
    std::filesystem::remove_all(options_.out);
    const Conversion c =
        convert({write("a.samples", samples_text(in_hand ? "eye_in_hand" : "eye_on_base", robot, tracking))}, options_);
    EXPECT_THAT(c.notes, Contains(HasSubstr("made-up robot")));
    const Fit f = fit(c.session);
    EXPECT_LT(f.residual_rms, 1e-7) << in_hand;
    const Rigid& expected = in_hand ? hand_from_camera : base_from_camera;
    EXPECT_LT((estimate(f).mount_from_sensor.translation - expected.translation).norm(), 1e-6) << in_hand;
    EXPECT_LT((estimate(f).mount_from_sensor.rotation - expected.rotation).norm(), 1e-6) << in_hand;
  }
}

TEST_F(Convert, TwoTablesOfPosesNeedNamesThatTellThemApart) {
  std::string flange, target;
  for (int i = 0; i < 12; ++i) {
    const Rigid hand{rotation_from_rpy({0.1 * i, 0.05 * i * i, -0.2 * i}), {0.3 + 0.02 * i, 0.1, 0.5 - 0.01 * i * i}};
    flange += pose_line(hand) + "\n";
    target += pose_line(inverse(Rigid{rotation_from_rpy({0, 1, 0}), {1, 0, 1}}) * hand) + "\n";
  }
  options_.eye_on_base = true;
  const Conversion c = converted({write("flange.csv", flange), write("target.csv", target)});
  EXPECT_LT(fit(c.session).residual_rms, 1e-7);
  EXPECT_THAT(refusal({write("a.csv", flange), write("b.csv", target)}), HasSubstr("flange.csv and target.csv"));
}

TEST_F(Convert, BagsWithTransformsArePairedByTimeWhereTheRobotStands) {
  const Rigid tcp_from_target{rotation_from_rpy({0.3, -0.2, 0.9}), {0.02, 0.05, 0.1}};
  const std::vector<Rigid> targets = target_poses(truth, tcp_from_target);
  const Chain chain = chain_of(truth.session);
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
  EXPECT_LT((estimate(f).markers_in_tcp[0] - tcp_from_target.translation).norm(), 1e-5);
}

std::string camera_info(const Camera& c, const Matrix3& r, double p3) {
  fixture::CdrWriter w;
  w.header(5, "camera").number(static_cast<std::uint32_t>(c.height)).number(static_cast<std::uint32_t>(c.width));
  w.text("plumb_bob").numbers({c.k1, c.k2, c.p1, c.p2, c.k3});
  w.numbers({c.fx, 0, c.cx, 0, c.fy, c.cy, 0, 0, 1}, false);
  const Matrix3 by_rows = r.transpose();
  w.numbers({by_rows.data(), by_rows.data() + 9}, false).numbers({800, 0, 400, p3, 0, 800, 300, 0, 0, 0, 1, 0}, false);
  return w.number(std::uint32_t{0}).number(std::uint32_t{0}).bytes();
}

TEST_F(Convert, BagsWithImagesOfTwoCameras) {
  Camera camera;
  camera.width = 8;
  camera.height = 6;
  camera.fx = camera.fy = 10;
  camera.cx = 4;
  camera.cy = 3;
  camera.k1 = -0.1;
  {
    fixture::BagWriter bag(folder.path / "bag");
    const int joints = bag.topic("/joint_states", "sensor_msgs/msg/JointState"),
              left = bag.topic("/stereo/left/image_raw", "sensor_msgs/msg/Image"),
              right = bag.topic("/stereo/right/image_raw", "sensor_msgs/msg/Image"),
              left_info = bag.topic("/stereo/left/camera_info", "sensor_msgs/msg/CameraInfo"),
              right_info = bag.topic("/stereo/right/camera_info", "sensor_msgs/msg/CameraInfo");
    bag.message(left_info, 0, camera_info(camera, Matrix3::Identity(), 0));
    bag.message(right_info, 0, camera_info(camera, rotation_from_rpy({0, 0.1, 0}), -800 * 0.12));
    const auto image = [](double stamp, const std::string& encoding, std::uint32_t step) {
      return fixture::CdrWriter()
          .header(stamp, "left")
          .number(std::uint32_t{6})
          .number(std::uint32_t{8})
          .text(encoding)
          .number(std::uint8_t{0})
          .number(step)
          .raw(std::string(6 * step, 'x'))
          .bytes();
    };
    for (int i = 0; i < 4; ++i) {
      const double t = 100 + 2 * i;
      for (double s = 0; s < 1.5; s += 0.02)
        bag.message(
            joints, t + s,
            fixture::joint_state(t + s, {"a1", "a2", "a3", "a4", "a5", "a6"}, {0.1 * i, 0.2, 0.3, 0.4, 0.5, 0.6}));
      bag.message(left, t + 0.5, image(t + 0.5, "mono8", 8));
      if (i != 2) bag.message(right, t + 0.503, image(t + 0.503, "rgb8", 24));
    }
  }
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

TEST_F(Convert, DamagedBagsAreRefused) {
  {
    fixture::BagWriter bag(folder.path / "bag");
    const int joints = bag.topic("/joint_states", "sensor_msgs/msg/JointState");
    std::string message = fixture::joint_state(1, {"a1", "a2"}, {0.1, 0.2});
    bag.message(joints, 1, message.substr(0, message.size() / 2));
  }
  EXPECT_THAT(refusal({folder.path / "bag"}), HasSubstr("bag is damaged"));
  EXPECT_THAT(refusal({write("no.db3", "SQLite format 3 it is not")}), HasSubstr("no ROS 2 bag"));
  EXPECT_THAT(refusal({write("a.mcap", "\x89MCAP0\r\n")}), HasSubstr("ros2 bag convert"));
}

TEST_F(Convert, ImagesWithSwappedSidesOfTheCalibration) {
  const std::string storage =
      "%YAML:1.0\n---\nimage_width: 6\nimage_height: 8\n"
      "M1: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n   data: [ 10., 0., 3.9, 0., 10., 2.9, 0., 0., 1. ]\n"
      "M2: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n   data: [ 10., 0., 4.1, 0., 10., 3.1, 0., 0., 1. ]\n"
      "R: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n   data: [ 1., 0., 0., 0., 1., 0., 0., 0., 1. ]\n"
      "T: !!opencv-matrix\n   rows: 3\n   cols: 1\n   dt: d\n   data: [ -120., 0., 0. ]\n";
  for (int i = 0; i < 3; ++i)
    for (const char* side : {"left", "right"})
      write(fmt::format("{}/{:03}.pgm", side, i), "P5\n8 6\n255\n" + std::string(48, 'x'));
  std::string joints = "a1,a2,a3,a4,a5,a6\n";
  for (int i = 0; i < 3; ++i) joints += fmt::format("{},0.1,0.2,0.3,0.4,0.5\n", 0.1 * i);
  const auto table = write("j.csv", joints), calibration = write("stereo.yml", storage);
  const Conversion c = converted({folder.path / "right", folder.path / "left", table, calibration});
  EXPECT_THAT(c.notes, Contains(HasSubstr("width and height swapped")));
  EXPECT_THAT(c.notes, Contains(HasSubstr("millimetres")));
  EXPECT_EQ(c.session.rig->at(0).camera.width, 8);
  EXPECT_THAT(c.session.observations[0].images[0], HasSubstr("left"));
  const auto turned = write(
      "turned.yml",
      std::string(storage).replace(storage.find("3.9"), 3, "2.9").replace(storage.find("0., 10., 2.9") + 9, 3, "3.9"));
  EXPECT_THAT(refusal({folder.path / "right", folder.path / "left", table, turned}), HasSubstr("turned by a quarter"));
  EXPECT_THAT(
      refusal({folder.path / "right", folder.path / "left", write("j.csv", joints + "0,0,0,0,0,0\n"), calibration}),
      HasSubstr("3 pairs of images and 4 lines"));
}

TEST_F(Convert, CamerasOfRosAndKalibr) {
  const std::string info = R"(image_width: 8
image_height: 6
camera_name: narrow/left
camera_matrix:
  rows: 3
  cols: 3
  data: [10.0, 0.0, 4.0, 0.0, 11.0, 3.0, 0.0, 0.0, 1.0]
distortion_model: plumb_bob
distortion_coefficients:
  rows: 1
  cols: 5
  data: [-0.1, 0.02, 0.001, 0.002, 0.0]
rectification_matrix:
  rows: 3
  cols: 3
  data: [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]
projection_matrix:
  rows: 3
  cols: 4
  data: [10.0, 0.0, 4.0, BASE, 0.0, 10.0, 3.0, 0.0, 0.0, 0.0, 1.0, 0.0]
)";
  const auto with_base = [&](const std::string& base) {
    std::string text = info;
    return text.replace(text.find("BASE"), 4, base);
  };
  for (int i = 0; i < 2; ++i)
    for (const char* side : {"left", "right"})
      write(fmt::format("{}/{:03}.pgm", side, i), "P5\n8 6\n255\n" + std::string(48, 'x'));
  const auto table = write("j.csv", "a1,a2,a3,a4,a5,a6\n0,0.1,0.2,0.3,0.4,0.5\n1,0.1,0.2,0.3,0.4,0.5\n");
  const std::vector<std::filesystem::path> images{folder.path / "left", folder.path / "right", table};
  const auto with = [&](std::initializer_list<std::filesystem::path> more) {
    std::vector<std::filesystem::path> all = images;
    all.insert(all.end(), more);
    return all;
  };
  const Conversion ros = converted(with({write("r.yaml", with_base("-1.5")), write("l.yaml", with_base("0.0"))}));
  EXPECT_NEAR(ros.session.rig->at(1).camera_from_first.translation.x(), -0.15, 1e-12);
  EXPECT_EQ(ros.session.rig->at(0).camera.p2, 0.002);
  EXPECT_THAT(refusal(with({write("r.yaml", with_base("0.0")), write("l.yaml", with_base("0.0"))})),
              HasSubstr("neither names the distance"));
  EXPECT_THAT(refusal(with({write("l.yaml", with_base("0.0"))})), HasSubstr("one camera alone"));
  const std::string chain = R"(cam0:
  camera_model: pinhole
  intrinsics: [10.0, 11.0, 4.0, 3.0]
  distortion_model: radtan
  distortion_coeffs: [-0.1, 0.02, 0.001, 0.002]
  resolution: [8, 6]
  rostopic: /cam0/image_raw
cam1:
  camera_model: pinhole
  intrinsics: [10.5, 11.5, 4.0, 3.0]
  distortion_model: MODEL
  distortion_coeffs: [-0.1, 0.02, 0.001, 0.002]
  resolution: [8, 6]
  T_cn_cnm1:
  - [1.0, 0.0, 0.0, -0.11]
  - [0.0, 1.0, 0.0, 0.0]
  - [0.0, 0.0, 1.0, 0.0]
  - [0.0, 0.0, 0.0, 1.0]
)";
  std::string radtan = chain, fisheye = chain;
  radtan.replace(radtan.find("MODEL"), 5, "radtan");
  fisheye.replace(fisheye.find("MODEL"), 5, "equidistant");
  EXPECT_EQ(converted(with({write("c.yaml", radtan)})).session.rig->at(1).camera_from_first.translation.x(), -0.11);
  EXPECT_THAT(refusal(with({write("c.yaml", fisheye)})), HasSubstr("equidistant"));
}

TEST_F(Convert, WhatIsMissingIsNamed) {
  const auto joints = write("j.csv", joints_csv()), points = write("p.csv", points_csv());
  EXPECT_THAT(refusal({joints}), HasSubstr("nothing that a sensor measured"));
  EXPECT_THAT(refusal({points}), HasSubstr("no joint readings"));
  options_.tcp.clear();
  EXPECT_THAT(refusal({joints, points}), AllOf(HasSubstr("--tcp"), HasSubstr("hand")));
  options_.tcp = "arm";
  EXPECT_THAT(refusal({joints, points}), AllOf(HasSubstr("no such link"), HasSubstr("hand")));
  options_.tcp = "hand";
  EXPECT_THROW(convert({joints, points}, options_), InputError) << "no robot";
  EXPECT_THAT(refusal({write("notes.txt", "hello world\nthis is no table\n")}), HasSubstr("not known"));
  EXPECT_THAT(refusal({folder.path / "nowhere"}), HasSubstr("is not there"));
  EXPECT_FALSE(std::filesystem::exists(options_.out / "session.xml"));
}

TEST_F(Convert, ASessionThatIsThereStays) {
  const auto joints = write("j.csv", joints_csv()), points = write("p.csv", points_csv());
  converted({joints, points});
  EXPECT_THROW(convert({joints, points, folder.path / "robot.urdf"}, options_), InputError);
}

}  // namespace
}  // namespace handsight
