// SPDX-License-Identifier: Apache-2.0
// Bad input, as a user meets it: one sentence that says what, where and what to do; exit code 2; nothing is lost.
#include <gtest/gtest.h>

#include <functional>

#include "cli/cli_runner.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

using test::read_text;
using test::run_cli;
using test::write_text;

const char robot_text[] = R"(<robot name="two_joints">
  <link name="base"/>
  <link name="upper"><inertial><origin xyz="0 0 0.1"/><mass value="2"/></inertial></link>
  <link name="hand"><inertial><origin xyz="0.05 0 0"/><mass value="1"/></inertial></link>
  <joint name="j1" type="revolute"><parent link="base"/><child link="upper"/><origin xyz="0 0 0.3"/><axis xyz="0 0 1"/><limit lower="-3" upper="3"/></joint>
  <joint name="j2" type="revolute"><parent link="upper"/><child link="hand"/><origin xyz="0.3 0 0"/><axis xyz="0 1 0"/><limit lower="-3" upper="3"/></joint>
</robot>
)";

const char session_text[] = R"(<?xml version="1.0"?>
<handsight_session version="1" title="Test">
  <robot file="robot.urdf" tcp="hand"/>
  <stereo mount="base">
    <mount_from_left xyz="1.2 0 0.5" rpy="-1.5708 0 1.5708" estimate="no"/>
    <right_from_left xyz="-0.1 0 0" rpy="0 0 0"/>
    <camera name="left" width="64" height="48" fx="60" fy="60" cx="32" cy="24"/>
    <camera name="right" width="64" height="48" fx="60" fy="60" cx="32" cy="24"/>
  </stereo>
  <markers count="3"/>
  <joints>j1 j2</joints>
  <observations>
    <observation id="0" time="1">
      <position>0.1 0.2</position>
      <images left="left.pgm" right="right.pgm"/>
      <marker index="0" left="30 20" right="24 20" by="hand"/>
      <marker index="1" left="36 20" right="30 20" by="hand"/>
      <marker index="2" left="33 26" right="27 26" by="hand"/>
    </observation>
    <observation id="1" time="2">
      <position>0.3 -0.1</position>
      <marker index="0" left="31 21" right="25 21"/>
      <marker index="1" left="37 21" right="31 21"/>
      <marker index="2" left="34 27" right="28 27"/>
    </observation>
  </observations>
</handsight_session>
)";

std::string pgm(int width, int height) {
  return "P5\n" + std::to_string(width) + " " + std::to_string(height) + "\n255\n" +
         std::string(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), '\x80');
}

struct Replacement {
  std::string from, to;
};

class BadInput : public testing::Test {
 protected:
  void SetUp() override {
    write_text(folder.path / "session" / "session.xml", session_text);
    write_text(folder.path / "session" / "robot.urdf", robot_text);
    write_text(folder.path / "session" / "left.pgm", pgm(64, 48));
    write_text(folder.path / "session" / "right.pgm", pgm(64, 48));
  }

  void change(const std::string& file, const Replacement& r) {
    std::string text = read_text(folder.path / "session" / file);
    const auto at = text.find(r.from);
    ASSERT_NE(at, std::string::npos) << r.from;
    text.replace(at, r.from.size(), r.to);
    write_text(folder.path / "session" / file, text);
  }

  /// The command refuses with exit code 2 and a sentence that holds every one of these words.
  void expect_refused(const std::string& command, const std::vector<std::string>& words) {
    const auto before = read_text(folder.path / "session" / "session.xml");
    const auto result = run_cli(folder.path, {command, (folder.path / "session").string()});
    EXPECT_EQ(result.exit_code, 2) << result.errors;
    EXPECT_GE(result.errors.size(), 20u);
    EXPECT_LE(result.errors.size(), 700u);
    for (const std::string& word : words)
      EXPECT_NE(result.errors.find(word), std::string::npos) << word << " in: " << result.errors;
    EXPECT_EQ(read_text(folder.path / "session" / "session.xml"), before);
  }

  TemporaryFolder folder;
};

TEST_F(BadInput, TheUnchangedSessionWorks) {
  const auto result = run_cli(folder.path, {"check", (folder.path / "session").string()});
  EXPECT_EQ(result.exit_code, 0) << result.errors << result.output;
}

TEST_F(BadInput, MissingSession) {
  const auto result = run_cli(folder.path, {"fit", (folder.path / "nowhere").string()});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.errors.find("nowhere"), std::string::npos);
}

TEST_F(BadInput, BrokenXmlWithItsLine) {
  change("session.xml", {"<joints>j1 j2</joints>", "<joints>j1 j2</jonts>"});
  expect_refused("fit", {"session.xml", "line 11"});
}

TEST_F(BadInput, AnotherVersion) {
  change("session.xml", {"version=\"1\" title", "version=\"2\" title"});
  expect_refused("fit", {"session.xml", "version"});
}

TEST_F(BadInput, WrongNumberOfJoints) {
  change("session.xml", {"0.3 -0.1", "0.3 -0.1 0.2"});
  expect_refused("fit", {"session.xml", "line 21", "position", "3", "2"});
}

TEST_F(BadInput, NotANumber) {
  change("session.xml", {"0.3 -0.1", "nan -0.1"});
  expect_refused("fit", {"session.xml", "line 21", "nan"});
}

TEST_F(BadInput, UnknownJoint) {
  change("session.xml", {"<joints>j1 j2", "<joints>j1 j7"});
  expect_refused("fit", {"j7"});
}

TEST_F(BadInput, UnknownLink) {
  change("session.xml", {"tcp=\"hand\"", "tcp=\"finger\""});
  expect_refused("fit", {"finger"});
  change("session.xml", {"tcp=\"finger\"", "tcp=\"hand\""});
  change("session.xml", {"mount=\"base\"", "mount=\"tripod\""});
  expect_refused("fit", {"tripod"});
}

TEST_F(BadInput, ACyclicRobot) {
  change("robot.urdf",
         {"<parent link=\"base\"/><child link=\"upper\"/>", "<parent link=\"hand\"/><child link=\"upper\"/>"});
  expect_refused("fit", {"robot.urdf"});
}

TEST_F(BadInput, ARobotWithTwoRoots) {
  change("robot.urdf", {"<link name=\"base\"/>", "<link name=\"base\"/><link name=\"table\"/>"});
  expect_refused("fit", {"robot.urdf", "table"});
}

TEST_F(BadInput, AMissingImageIsAProblemOfTheCheck) {
  std::filesystem::remove(folder.path / "session" / "left.pgm");
  expect_refused("check", {"left.pgm"});
}

TEST_F(BadInput, ATruncatedImage) {
  write_text(folder.path / "session" / "left.pgm", pgm(64, 48).substr(0, 800));
  expect_refused("check", {"left.pgm"});
}

TEST_F(BadInput, AnImageOfAnotherSize) {
  write_text(folder.path / "session" / "right.pgm", pgm(128, 96));
  expect_refused("check", {"right.pgm", "128 x 96", "64 x 48"});
}

TEST_F(BadInput, AnImageOutsideTheSession) {
  change("session.xml", {"left=\"left.pgm\"", "left=\"../left.pgm\""});
  expect_refused("fit", {"session.xml", "../left.pgm"});
}

TEST_F(BadInput, NoObservation) {
  const std::string text = read_text(folder.path / "session" / "session.xml");
  const auto from = text.find("    <observation id"), to = text.find("  </observations>");
  write_text(folder.path / "session" / "session.xml", text.substr(0, from) + text.substr(to));
  expect_refused("fit", {"observation"});
}

TEST_F(BadInput, TwoObservationsWithOneId) {
  change("session.xml", {"id=\"1\"", "id=\"0\""});
  expect_refused("fit", {"session.xml", "line 20", "0"});
}

TEST_F(BadInput, TimeThatGoesBack) {
  change("session.xml", {"time=\"2\"", "time=\"0.5\""});
  expect_refused("fit", {"session.xml", "line 20", "0.5"});
}

TEST_F(BadInput, ACameraWithoutFocalLength) {
  change("session.xml", {"fx=\"60\"", "fx=\"0\""});
  expect_refused("fit", {"session.xml", "fx"});
}

TEST_F(BadInput, ACentreOfMassFarAwayIsAWarning) {
  change("robot.urdf", {"xyz=\"0 0 0.1\"", "xyz=\"0 0 500\""});
  const auto result = run_cli(folder.path, {"check", (folder.path / "session").string()});
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_NE((result.output + result.errors).find("500"), std::string::npos);
}

TEST_F(BadInput, WrongUsageOfTheOptions) {
  EXPECT_EQ(run_cli(folder.path, {"fit", (folder.path / "session").string(), "--objective", "sound"}).exit_code, 2);
  EXPECT_EQ(run_cli(folder.path, {"fit"}).exit_code, 2);
  EXPECT_EQ(run_cli(folder.path, {"no_such_command"}).exit_code, 2);
  EXPECT_EQ(run_cli(folder.path, {}).exit_code, 2);
  EXPECT_EQ(run_cli(folder.path, {"--help"}).exit_code, 0);
}

TEST_F(BadInput, WhatIsMissingIsSaidWithWhatItIs) {
  const auto errors = [&](const std::vector<std::string>& arguments) { return run_cli(folder.path, arguments).errors; };
  EXPECT_EQ(errors({"convert", "images"}),
            "--out is missing: Folder to make; it must not hold a session already.\n"
            "handsight-cli convert --help lists all that it takes.\n");
  EXPECT_EQ(errors({"fit"}).find("SESSION is missing: A session's folder or its session.xml"), 0U) << errors({"fit"});
  EXPECT_EQ(errors({"checks", "images"}),
            "There is no command \"checks\"; is check meant?\nhandsight-cli --help says what each does.\n");
  const std::string unknown = errors({"--threads", "2", "calibrate", "images"});
  EXPECT_EQ(unknown.find("There is no command \"calibrate\"; the commands are check detect label "), 0U) << unknown;
  EXPECT_EQ(errors({}).find("No command is given; the commands are check "), 0U) << errors({});
}

TEST_F(BadInput, EveryCommandIsListedAndRefusesWhatIsNoSession) {
  const auto help = run_cli(folder.path, {"--help"});
  for (const std::string command : {"check", "fit", "diagnose", "improve", "plan"}) {
    EXPECT_NE(help.output.find(command), std::string::npos) << command;
    EXPECT_EQ(run_cli(folder.path, {command, (folder.path / "no_such_session").string()}).exit_code, 2) << command;
  }
  for (const std::string command : {"fit", "diagnose", "improve"}) {
    const auto refused =
        run_cli(folder.path, {command, (folder.path / "session").string(), "--effects", "no_such_effect"});
    EXPECT_EQ(refused.exit_code, 2) << command;
    EXPECT_NE(refused.errors.find("not in the catalogue"), std::string::npos) << refused.errors;
  }
}

TEST_F(BadInput, AnExportThatCannotBeWrittenLeavesNothing) {
  const auto result = run_cli(folder.path, {"fit", (folder.path / "session").string(), "--export",
                                            (folder.path / "no" / "such" / "folder.xml").string()});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_FALSE(std::filesystem::exists(folder.path / "no"));
}

}  // namespace
}  // namespace handsight
