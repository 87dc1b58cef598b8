// SPDX-License-Identifier: Apache-2.0
// export, correct, convert and compare as a user runs them.
#include <gtest/gtest.h>
#include <unistd.h>

#include "cli/cli_runner.h"
#include "session/session_xml.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

using test::run_cli;

std::string joint_paths_sample(const std::string& name) {
  return std::string(HANDSIGHT_SOURCE_DIR) + "/sample_sessions/" + name;
}

/// The third of a session's joints.
std::string joint_of(const std::string& session) {
  const std::string text = test::read_text(session + "/session.xml");
  const std::size_t begin = text.find("<joints>") + 8;
  std::istringstream names(text.substr(begin, text.find("</joints>") - begin));
  std::string name;
  for (int i = 0; i < 3; ++i) names >> name;
  return name;
}

/// Leaves the first or the second half of a session's observations.
void keep_half(const std::string& session, bool first) {
  std::string text = test::read_text(session + "/session.xml"), kept;
  std::size_t at = text.find("<observation "), number = 0;
  kept = text.substr(0, at);
  while (at != std::string::npos) {
    const std::size_t end = text.find("</observation>", at) + 14, next = text.find("<observation ", end);
    if ((number++ < 40) == first) kept += text.substr(at, end - at);
    if (next == std::string::npos) kept += text.substr(end);
    at = next;
  }
  test::write_text(session + "/session.xml", kept);
}

class Ways : public testing::Test {
 protected:
  std::string at(const std::string& name) const { return (folder.path / name).string(); }

  /// A calibration with effects, and the robot that it is of.
  void calibrate() {
    const auto fit = run_cli(folder.path, {"fit", joint_paths_sample("hidden_3"), "--effects", "joint_elasticity",
                                           "joint_offset", "--export", at("calibration.xml")});
    ASSERT_EQ(fit.exit_code, 0) << fit.errors;
    const auto session = test::read_text(joint_paths_sample("hidden_3") + "/session.xml");
    const std::size_t begin = session.find("file=\"") + 6;
    robot = joint_paths_sample("hidden_3") + "/" + session.substr(begin, session.find('"', begin) - begin);
    const std::size_t first = session.find("<position>") + 10;
    position = session.substr(first, session.find("</position>") - first);
  }

  TemporaryFolder folder;
  std::string robot, position;
};

TEST_F(Ways, ExportsOfEveryKindAreWrittenWhole) {
  calibrate();
  for (const std::string kind : {"urdf", "yaml", "static_tf", "opencv", "cpp", "python", "csv", "xacro", "mjcf", "sdf",
                                 "dh", "ros2_control", "lerobot"}) {
    const auto out = run_cli(
        folder.path, {"export", at("calibration.xml"), "--robot", robot, "--as", kind, "--out", at("out." + kind)});
    EXPECT_EQ(out.exit_code, 0) << kind << out.errors;
    EXPECT_GT(test::read_text(at("out." + kind)).size(), 100u) << kind;
    const auto piped =
        run_cli(folder.path, {"export", at("calibration.xml"), "--robot", robot, "--as", kind, "--out", "-"});
    EXPECT_EQ(piped.output, test::read_text(at("out." + kind))) << kind;
  }
  EXPECT_EQ(run_cli(folder.path, {"export", at("calibration.xml"), "--as", "cpp", "--out", at("x")}).exit_code, 2);
  EXPECT_EQ(run_cli(folder.path, {"export", at("calibration.xml"), "--robot", robot, "--as", "excel", "--out", at("x")})
                .exit_code,
            2);
  EXPECT_EQ(run_cli(folder.path, {"export", at("calibration.xml"), "--robot", robot, "--as", "cpp", "--out", robot})
                .exit_code,
            2)
      << "never over the robot that it reads";
  EXPECT_FALSE(std::filesystem::exists(at("x")));
}

TEST_F(Ways, TheExportedPythonFileSaysWhatPredictSays) {
  calibrate();
  ASSERT_EQ(run_cli(folder.path,
                    {"export", at("calibration.xml"), "--robot", robot, "--as", "python", "--out", at("hand.py")})
                .exit_code,
            0);
  const auto predicted =
      run_cli(folder.path, {"predict", at("calibration.xml"), "--robot", robot, "--position", position, "--json", "-"});
  ASSERT_EQ(predicted.exit_code, 0) << predicted.errors;
  const std::string command = "echo '" + position + "' | python3 -I '" + at("hand.py") + "' > '" + at("said.txt") + "'";
  ASSERT_EQ(std::system(command.c_str()), 0);
  std::istringstream said(test::read_text(at("said.txt")));
  const auto json = predicted.json();
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 4; ++c) {
      double x = 0;
      said >> x;
      EXPECT_NEAR(x, json[0]["root_from_tcp_est"][r][c].get<double>(), 1e-9);
    }
}

TEST_F(Ways, CorrectTellsWhatToCommandAndWhatItBuys) {
  calibrate();
  const auto out =
      run_cli(folder.path, {"correct", at("calibration.xml"), "--robot", robot, "--position", position, "--json", "-"});
  ASSERT_EQ(out.exit_code, 0) << out.errors;
  const auto json = out.json();
  EXPECT_TRUE(json[0]["reached"].get<bool>());
  EXPECT_GT(json[0]["error_before_m"].get<double>(), 1e-4);
  EXPECT_LT(json[0]["error_after_m"].get<double>(), 1e-6);
  EXPECT_GT(json[0]["sigma_m"].get<double>(), 0);
  std::string command;
  for (const auto& q : json[0]["corrected"]) command += q.dump() + " ";
  const auto there =
      run_cli(folder.path, {"predict", at("calibration.xml"), "--robot", robot, "--position", command, "--json", "-"})
          .json();
  const auto meant =
      run_cli(folder.path, {"predict", at("calibration.xml"), "--robot", robot, "--position", position, "--json", "-"})
          .json();
  for (std::size_t r = 0; r < 3; ++r)
    EXPECT_NEAR(there[0]["root_from_tcp_est"][r][3].get<double>(), meant[0]["root_from_tcp"][r][3].get<double>(), 1e-6);
  const auto far = run_cli(folder.path, {"correct", at("calibration.xml"), "--robot", robot, "--position", position,
                                         "--target", "9 0 0 0 0 0"});
  EXPECT_EQ(far.exit_code, 1);
  EXPECT_NE(far.output.find("not reached"), std::string::npos);
  EXPECT_EQ(run_cli(folder.path, {"correct", at("calibration.xml"), "--robot", robot, "--position", position,
                                  "--target", "9 0 nan 0 0 0"})
                .exit_code,
            2);
  const auto gain = run_cli(
      folder.path, {"correct", joint_paths_sample("hidden_3"), "--effects", "joint_elasticity", "--gain", "50"});
  EXPECT_EQ(gain.exit_code, 0) << gain.errors;
  EXPECT_NE(gain.output.find("Over 50 poses"), std::string::npos);
}

TEST_F(Ways, ConvertSaysWhatItTookAndWhatIsMissing) {
  test::write_text(at("robot.urdf"),
                   "<robot name='r'><link name='base'/><link name='tip'/><joint name='j' type='revolute'>"
                   "<parent link='base'/><child link='tip'/><axis xyz='0 0 1'/></joint></robot>");
  test::write_text(at("joints.csv"), "time,j\n0,0.1\n5,0.5\n9,1.2\n");
  test::write_text(at("points.csv"), "time,m0_x,m0_y,m0_z\n0,1,0.1,0\n5,0.9,0.4,0\n9,0.4,0.9,0\n");
  const auto out = run_cli(folder.path, {"convert", at("joints.csv"), at("points.csv"), "--robot", at("robot.urdf"),
                                         "--tcp", "tip", "--out", at("made")});
  EXPECT_EQ(out.exit_code, 0) << out.errors;
  EXPECT_NE(out.output.find("a table of points"), std::string::npos);
  EXPECT_NE(out.errors.find("no link has a mass"), std::string::npos);
  EXPECT_NE(out.errors.find("no limits are given for j"), std::string::npos);
  EXPECT_EQ(run_cli(folder.path, {"check", at("made")}).exit_code, 0);
  EXPECT_EQ(run_cli(folder.path,
                    {"convert", at("joints.csv"), "--robot", at("robot.urdf"), "--tcp", "tip", "--out", at("none")})
                .exit_code,
            2);
  EXPECT_FALSE(std::filesystem::exists(at("none/session.xml")));
}

TEST_F(Ways, CompareFindsALostZeroAndNothingWhereNothingIs) {
  const auto simulate = [&](const std::string& name, const std::string& seed, const std::vector<std::string>& effect) {
    std::vector<std::string> arguments{
        "simulate", "--like", joint_paths_sample("hidden_2"), "--observations", "80", "--seed", seed,
        "--out",    at(name)};
    arguments.insert(arguments.end(), effect.begin(), effect.end());
    const auto out = run_cli(folder.path, arguments);
    ASSERT_EQ(out.exit_code, 0) << out.errors;
  };
  simulate("before", "7", {});
  // The same seed makes the same hand and poses; half of them are before, half after.
  simulate("after", "7", {"--effect", "joint_offset:" + joint_of(joint_paths_sample("hidden_2")) + ".offset=0.004"});
  keep_half(at("before"), true);
  keep_half(at("after"), false);
  const auto changed = run_cli(folder.path, {"compare", at("before"), at("after"), "--json", "-"});
  ASSERT_EQ(changed.exit_code, 0) << changed.errors;
  EXPECT_EQ(changed.json()["verdict"], "changed") << changed.json()["reason"];
  EXPECT_EQ(changed.json()["changes"][0]["id"], "joint_offset");
  EXPECT_NEAR(changed.json()["changes"][0]["parameters"][0]["value"].get<double>(), 0.004, 2e-4);
  simulate("later", "7", {});
  keep_half(at("later"), false);
  const auto same = run_cli(folder.path, {"compare", at("before"), at("later"), "--json", "-"});
  EXPECT_EQ(same.json()["verdict"], "unchanged") << same.json()["reason"];
  EXPECT_EQ(run_cli(folder.path, {"compare", at("before"), joint_paths_sample("thesis_simulation")}).exit_code, 2);
}

TEST_F(Ways, BatchHasALineForEachAndTheSameOnesWithAnyNumberOfJobs) {
  test::write_text(at("broken/session.xml"), "<handsight_session version='1'>");
  const std::vector<std::string> sessions{joint_paths_sample("hidden_1"), at("broken"), joint_paths_sample("hidden_2"),
                                          at("nowhere")};
  const auto with_jobs = [&](const std::string& jobs) {
    std::vector<std::string> arguments{"batch", "--jobs", jobs, "--csv", "-"};
    arguments.insert(arguments.end(), sessions.begin(), sessions.end());
    return run_cli(folder.path, arguments);
  };
  const auto one = with_jobs("1"), three = with_jobs("3");
  EXPECT_EQ(one.exit_code, 0) << one.errors;
  EXPECT_EQ(one.output, three.output);
  std::istringstream lines(one.output);
  std::vector<std::string> all;
  for (std::string line; std::getline(lines, line);) all.push_back(line);
  ASSERT_EQ(all.size(), 5u) << one.output;
  EXPECT_NE(all[1].find("hidden_1,done,80,80,"), std::string::npos) << all[1];
  EXPECT_NE(all[2].find("broken,failed,"), std::string::npos);
  EXPECT_NE(all[3].find("hidden_2,done,"), std::string::npos);
  EXPECT_NE(all[4].find("nowhere,failed,"), std::string::npos);
  EXPECT_EQ(run_cli(folder.path, {"batch", at("broken"), at("nowhere")}).exit_code, 2);
}

/// A robot that is simulated while it is watched; the watch is stopped and started again on the way.
TEST_F(Ways, OnlineWatchTakesWhatArrivesAndSurvivesARestart) {
  test::write_text(
      at("robot.urdf"),
      "<robot name='r'><link name='base'/><link name='l1'/><link name='tip'/>"
      "<joint name='j1' type='revolute'><parent link='base'/><child link='l1'/><axis xyz='0 0 1'/>"
      "<limit lower='-2' upper='2'/></joint><joint name='j2' type='revolute'><parent link='l1'/>"
      "<child link='tip'/><origin xyz='0.4 0 0'/><axis xyz='0 1 0'/><limit lower='-2' upper='2'/></joint></robot>");
  test::write_text(
      at("like/session.xml"),
      "<handsight_session version='1'><robot file='robot.urdf' tcp='tip'/><tracker mount='base' sigma='0.0002'>"
      "<mount_from_tracker xyz='1 0 0.2' rpy='0 0 0'/></tracker><markers count='3'/><joints>j1 "
      "j2</joints><observations>"
      "<observation id='0' time='0'><position>0 0</position></observation></observations></handsight_session>");
  std::filesystem::copy(at("robot.urdf"), at("like/robot.urdf"));
  const std::string cli = HANDSIGHT_BINARY_DIR "/app/cli/handsight-cli";
  const std::string robot_runs = "'" + cli + "' simulate --like '" + at("like") + "' --live '" + at("live") +
                                 "' --rate 10 --observations 21 --seed 3 > /dev/null 2>&1 &";
  ASSERT_EQ(std::system(robot_runs.c_str()), 0);
  for (int i = 0; i < 100 && !std::filesystem::exists(at("live/joints.csv")); ++i) usleep(50000);
  const auto first = run_cli(folder.path, {"online", at("live"), "--watch", "--for", "1", "--save"});
  EXPECT_EQ(first.exit_code, 0) << first.errors;
  const auto second = run_cli(folder.path, {"online", at("live"), "--watch", "--for", "4", "--save"});
  EXPECT_EQ(second.exit_code, 0) << second.errors;
  EXPECT_NE(second.output.find("of 21 observations taken; saved"), std::string::npos) << first.output << second.output;
  const std::string saved = test::read_text(at("live/session.xml"));
  std::size_t count = 0;
  for (std::size_t found = saved.find("<observation "); found != std::string::npos;
       found = saved.find("<observation ", found + 1))
    ++count;
  EXPECT_EQ(count, 21u) << "each came once";
}

/// One camera and a board, nothing labelled: what arrives is found in the images.
TEST_F(Ways, OnlineWatchTakesImagesOfOneCameraAndABoard) {
  const auto played = run_cli(folder.path, {"simulate", "--like", joint_paths_sample("rigs/one_camera_board"), "--live",
                                            at("live"), "--rate", "1000", "--observations", "14", "--seed", "4"});
  ASSERT_EQ(played.exit_code, 0) << played.errors;
  const auto watched = run_cli(folder.path, {"online", at("live"), "--watch", "--for", "2", "--save"});
  EXPECT_EQ(watched.exit_code, 0) << watched.errors << watched.output;
  EXPECT_NE(watched.output.find(" of 14 observations taken; saved"), std::string::npos) << watched.output;
  EXPECT_GE(read_session(at("live")).observations.size(), 14u);
  int used = 0;
  for (const Observation& o : read_session(at("live")).observations) used += o.decision == Decision::accepted;
  EXPECT_GE(used, 11) << watched.output;
}

}  // namespace
}  // namespace handsight
