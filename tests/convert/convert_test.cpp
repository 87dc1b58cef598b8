// SPDX-License-Identifier: Apache-2.0
// Sessions from what users have: recognised by content, wrong units and orders found and said, the same calibration at
// the end.
#include "convert/convert_fixture.h"
#include "fixtures/drawn.h"

namespace handsight {
namespace {

using testing::Contains;
using testing::HasSubstr;

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

std::string pose_line(const Rigid& pose, const char* between = ",") {
  const Eigen::Quaterniond q(pose.rotation);
  const Vector3& t = pose.translation;
  return fmt::format("{1}{0}{2}{0}{3}{0}{4}{0}{5}{0}{6}{0}{7}", between, t.x(), t.y(), t.z(), q.x(), q.y(), q.z(),
                     q.w());
}

TEST_F(Convert, PosesOfATargetCountWhole) {
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
    EXPECT_TRUE(c.session.pose_sensor.has_value()) << name;
    EXPECT_THAT(c.notes, Contains(HasSubstr("counts whole, place and turn"))) << name;
    const Fit f = fit(c.session);
    EXPECT_LT(f.residual_rms, 1e-7) << name;
    // Of a sensor that tells poses the body's frame is the target's own.
    EXPECT_LT(small_motion_between(tcp_from_target, f.tcp_from_body).norm(), 1e-6) << name;
  }
}

TEST_F(Convert, TurnsOfATargetAreFoundByTheRobotsJoints) {
  const Rigid tcp_from_target{rotation_from_rpy({0.3, -0.2, 0.9}), {0.02, 0.05, 0.1}};
  std::string csv = "x,y,z,rx,ry,rz\n";
  for (const Rigid& pose : target_poses(truth, tcp_from_target)) {
    const Vector3 &t = pose.translation, v = vector_from_rotation(pose.rotation);
    csv += fmt::format("{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g}\n", t.x(), t.y(), t.z(), v.x(), v.y(), v.z());
  }
  const Conversion c = converted({write("j.csv", joints_csv()), write("target.csv", csv)});
  EXPECT_THAT(c.notes, Contains(HasSubstr("read as rotation vectors")));
  EXPECT_LT(small_motion_between(tcp_from_target, fit(c.session).tcp_from_body).norm(), 1e-6);
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
    base_from_hand.push_back({rotation_from_rpy({uniform(random), uniform(random), uniform(random)}),
                              Vector3(0.5, 0, 0.5) + fixture::drawn_3([&] {
                                                       return uniform(random);
                                                     }).cwiseProduct(Vector3(0.2, 0.3, 0.2))});
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
    EXPECT_THAT(c.notes, Contains(HasSubstr("only where its flange is")));
    EXPECT_TRUE(c.session.robot.is_of_poses);
    EXPECT_FALSE(std::filesystem::exists(options_.out / "robot.urdf")) << "there is none";
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
