// SPDX-License-Identifier: Apache-2.0
// Sessions in their folders: the file, its robot, its images.
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>

#include "base/files.h"
#include "session_texts.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class SessionFolder : public testing::Test {
 protected:
  SessionFolder() {
    replace_file(home / "robot.urdf", small_robot);
    replace_file(home / "session.xml", small_session);
  }
  void write(const std::string& piece, const std::string& by) {
    replace_file(home / "session.xml", changed(small_session, piece, by));
  }
  std::string refused() {
    return find_refusal([&] { read_session(home); });
  }

  TemporaryFolder temporary;
  std::filesystem::path home = temporary.path;
};

TEST_F(SessionFolder, IsReadByItsFolderOrItsFile) {
  for (const auto& path : {home, home / "", home / "session.xml"}) {
    const Session session = read_session(path);
    EXPECT_EQ(session.robot.joints.size(), 4u);
    EXPECT_EQ(session.file, home / "session.xml");
    EXPECT_EQ(std::filesystem::canonical(folder(session)), std::filesystem::canonical(home));
  }
}

TEST_F(SessionFolder, WhatIsNotThereIsRefused) {
  EXPECT_THAT(find_refusal([&] { read_session(home / "nowhere"); }), HasSubstr("no such file"));
  std::filesystem::remove(home / "session.xml");
  EXPECT_THAT(refused(), HasSubstr("holds no session.xml"));
  write("robot.urdf", "other.urdf");
  EXPECT_THAT(refused(), HasSubstr("session.xml, line 3: <robot> has file=\"other.urdf\", which is not there"));
  write("robot.urdf", ".");
  EXPECT_THAT(refused(), HasSubstr("which is not there"));
}

TEST_F(SessionFolder, JointsAndLinksAreTheRobots) {
  write("j1 j2", "j1 j3");
  EXPECT_EQ(refused(),
            "session.xml, line 13: <joints> names \"j3\", which the robot does not have, expected joints of the "
            "robot that move by themselves.");
  write("j1 j2", "j1 welded");
  EXPECT_THAT(refused(), HasSubstr("names \"welded\", which is fixed"));
  write("j1 j2", "j1 follower");
  EXPECT_THAT(refused(), HasSubstr("names \"follower\", which follows other joints"));
  write("tcp=\"hand\"", "tcp=\"foot\"");
  EXPECT_THAT(refused(), HasSubstr("line 3: <robot> tcp=\"foot\" is no link of the robot"));
  write("mount=\"base\"", "mount=\"moon\"");
  EXPECT_THAT(refused(), HasSubstr("line 5: <stereo> mount=\"moon\" is no link of the robot"));
}

TEST_F(SessionFolder, TheRobotsRefusalsNameTheRobotsFile) {
  replace_file(home / "robot.urdf", "<robot/>");
  EXPECT_THAT(refused(), HasSubstr("robot.urdf, line 1: <robot> has no <link>"));
}

TEST_F(SessionFolder, TheRobotsNotesAreTheSessions) {
  replace_file(home / "robot.urdf",
               changed(small_robot, "<link name=\"one\"/>",
                       "<link name=\"one\"><inertial><origin xyz=\"0 0 500\"/><mass value=\"1\"/></inertial></link>"));
  EXPECT_THAT(read_session(home).notes, ElementsAre(HasSubstr("500 m")));
}

TEST_F(SessionFolder, ARobotOutsideTheFolderIsNotRead) {
  const TemporaryFolder outside;
  replace_file(outside.path / "robot.urdf", small_robot);
  replace_file(outside.path / "secret", "root:x:0:0");
  write("robot.urdf", (outside.path / "secret").string());
  EXPECT_THAT(refused(), HasSubstr("session.xml, line 3: <robot> has file="));
  EXPECT_THAT(refused(), HasSubstr("leads out of the session's folder"));
  EXPECT_THAT(refused(), testing::Not(HasSubstr("root:x")));
  write("robot.urdf", "../" + outside.path.filename().string() + "/robot.urdf");
  EXPECT_THAT(refused(), HasSubstr("leads out of the session's folder"));
  ::setenv(robot_folders_variable, ("/nowhere:" + outside.path.string()).c_str(), 1);
  EXPECT_EQ(refused(), "nothing was refused") << "the user has named the folder";
  ::unsetenv(robot_folders_variable);
  const auto collection = outside.path / "collection";
  std::filesystem::create_directories(collection / "robots");
  replace_file(collection / "robots" / "robot.urdf", small_robot);
  std::filesystem::create_directories(collection / "rigs" / "one");
  replace_file(collection / "rigs" / "one" / "session.xml",
               changed(small_session, "robot.urdf", "../../robots/robot.urdf"));
  EXPECT_EQ(find_refusal([&] { read_session(collection / "rigs" / "one"); }), "nothing was refused");
  std::filesystem::remove(home / "robot.urdf");
  std::filesystem::create_symlink(outside.path / "robot.urdf", home / "robot.urdf");
  write("robot.urdf", "robot.urdf");
  EXPECT_THAT(refused(), HasSubstr("leads out of the session's folder"));
}

TEST_F(SessionFolder, LinksOutOfTheFolderAreRefused) {
  const TemporaryFolder outside;
  replace_file(outside.path / "7_left.png", "secret");
  EXPECT_EQ(refused(), "nothing was refused") << "images that do not exist are no matter of this reader";
  std::filesystem::create_directory_symlink(outside.path, home / "images");
  EXPECT_THAT(refused(),
              HasSubstr("line 15: the image \"images/7_left.png\" of observation 7 leads out of the session's folder"));
  std::filesystem::remove(home / "images");
  std::filesystem::create_directory(home / "images");
  std::filesystem::create_symlink(outside.path / "7_left.png", home / "images" / "7_right.png");
  EXPECT_THAT(refused(), HasSubstr("images/7_right.png"));
  std::filesystem::remove(home / "images" / "7_right.png");
  replace_file(home / "real.png", "an image");
  std::filesystem::create_symlink("../real.png", home / "images" / "7_right.png");
  EXPECT_EQ(refused(), "nothing was refused") << "links inside are fine";
}

TEST_F(SessionFolder, WhatAnotherProgramSavedIsNotReplaced) {
  Session mine = read_session(home);
  Session theirs = mine;
  mine.observations.front().decision = Decision::excluded;
  theirs.observations.front().reason = "theirs";
  theirs.observations.front().decision = Decision::rejected;
  replace_session(theirs);
  EXPECT_THAT(find_refusal([&] { replace_session(mine); }), HasSubstr("another program has changed the file"));
  EXPECT_EQ(read_session(home).observations.front().reason, "theirs");
  mine.file = home / "copy.xml";
  save_session(mine);
  EXPECT_EQ(read_session(home / "copy.xml").observations.front().decision, Decision::excluded);
}

TEST_F(SessionFolder, NoResultGoesOverItsFiles) {
  const Session session = read_session(home);
  EXPECT_THAT(find_refusal([&] { require_no_session_file(session, home / "session.xml"); }),
              HasSubstr("belongs to the session"));
  EXPECT_THAT(find_refusal([&] { require_no_session_file(session, home / ".." / home.filename() / "robot.urdf"); }),
              HasSubstr("belongs to the session"));
  EXPECT_EQ(find_refusal([&] { require_no_session_file(session, home / "calibration.xml"); }), "nothing was refused");
}

TEST(SessionFiles, SharedSessionsAreRead) {
  const std::filesystem::path shared = HANDSIGHT_SHARED_DIR;
  if (!std::filesystem::exists(shared / "examples")) GTEST_SKIP() << "no shared examples on this machine";
  const Session hidden = read_session(shared / "examples/nothing_hidden");
  EXPECT_EQ(hidden.observations.at(7).decision, Decision::excluded);
  EXPECT_TRUE(std::ranges::any_of(hidden.observations.at(5).sightings,
                                  [](const Sighting& s) { return seen_by(s, 0) && !seen_by(s, 1); }));
  for (const Sighting& sighting : hidden.observations.at(5).sightings)
    EXPECT_TRUE(seen_by(sighting, 0) || seen_by(sighting, 1));
  EXPECT_THAT(hidden.notes, IsEmpty());
  EXPECT_THAT(read_session(shared / "examples/sagging/session.xml").notes, IsEmpty());
  if (!std::filesystem::exists(shared / "real/justin_right_even")) GTEST_SKIP() << "no real sets on this machine";
  const Session justin = read_session(shared / "real/justin_right_even");
  EXPECT_EQ(justin.observations.size(), 250u);
  EXPECT_EQ(justin.joints.size(), 17u);
  EXPECT_TRUE(justin.mount.estimate);
  EXPECT_THAT(justin.notes, IsEmpty());
}

}  // namespace
}  // namespace handsight
