// SPDX-License-Identifier: Apache-2.0
#include "session/new_session.h"

#include <gtest/gtest.h>

#include <fstream>

#include "base/error.h"
#include "base/files.h"
#include "robot/urdf.h"
#include "session/session_xml.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

class NewSessionTest : public testing::Test {
 protected:
  NewSessionTest() {
    std::filesystem::create_directories(folder.path / "a");
    std::filesystem::create_directories(folder.path / "b");
  }
  void touch(const std::string& name) { std::ofstream(folder.path / name) << "x"; }
  NewSession parts() {
    NewSession s;
    s.folder = folder.path / "made";
    s.title = "Made";
    s.urdf = std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions/first_steps/justin.urdf";
    s.tcp = "right_hand";
    s.mount = "head_tcp";
    const Session like = read_session(std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions/first_steps");
    s.rig = *like.rig;
    s.joints = like.joints;
    for (int i = 0; i < 2; ++i) s.positions.push_back(like.observations[static_cast<std::size_t>(i)].position);
    touch("a/l7.png");
    touch("b/l7.png");
    touch("a/l9.png");
    s.images = find_images({folder.path / "a", folder.path / "b"});
    return s;
  }
  TemporaryFolder folder;
};

TEST_F(NewSessionTest, PairsGoByTheNumberNotByTheOrder) {
  for (const char* name : {"a/left_2.png", "a/left_10.png", "a/left_3.png", "b/right_03.jpg", "b/right_10.jpg"})
    touch(name);
  const auto pairs = find_image_pairs(folder.path / "a", folder.path / "b");
  ASSERT_EQ(pairs.size(), 3U);
  EXPECT_EQ(pairs[0].number, 2);
  EXPECT_TRUE(pairs[0].right.empty()) << "a missing image does not shift the others";
  EXPECT_EQ(pairs[1].right.filename(), "right_03.jpg");
  EXPECT_EQ(pairs[2].left.filename(), "left_10.png");
}

TEST_F(NewSessionTest, ImagesNamedByDateAndTimeAreInOrderOfTime) {
  const std::vector<std::string> in_order{"s_2024-07-23_16-02-47.jpg", "s_2024-07-23_16-03-01.jpg",
                                          "s_2024-07-23_16-03-40.jpg", "s_2024-07-23_16-04-11.jpg"};
  for (const std::string& name : in_order) touch("a/" + name);
  const auto images = find_images({folder.path / "a"});
  ASSERT_EQ(images.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(images[i].files[0].filename(), in_order[i]);
}

TEST_F(NewSessionTest, ADigitMayBeginACamerasName) {
  NewSession digits = parts();
  digits.rig.cameras[0].name = "0";
  digits.rig.cameras[1].name = "1";
  std::vector<Message> notes;
  const Session made = make_session(digits, &notes);
  EXPECT_EQ(made.rig->at(0).name, "camera_0");
  EXPECT_EQ(made.rig->at(1).name, "camera_1");
  EXPECT_NE(notes[0].find("camera_0"), std::string::npos);
}

TEST_F(NewSessionTest, OneFolderIsToldApartByNames) {
  for (const char* name : {"a/000_left.png", "a/000_right.png", "a/001_right.png", "a/001_left.png", "a/readme.txt"})
    touch(name);
  const auto pairs = find_image_pairs(folder.path / "a", folder.path / "a");
  ASSERT_EQ(pairs.size(), 2U);
  EXPECT_EQ(pairs[1].left.filename(), "001_left.png");
  EXPECT_EQ(pairs[1].right.filename(), "001_right.png");
}

TEST_F(NewSessionTest, TheSameNumberTwiceIsRefused) {
  touch("a/left_2.png");
  touch("a/left_02.png");
  touch("b/right_2.png");
  EXPECT_THROW(find_image_pairs(folder.path / "a", folder.path / "b"), InputError);
  EXPECT_THROW(find_image_pairs(folder.path / "b", folder.path / "nowhere"), InputError);
}

TEST_F(NewSessionTest, IsWrittenWholeWithItsImagesAndRobot) {
  std::vector<Message> notes;
  const Session made = make_session(parts(), &notes);
  EXPECT_EQ(made.title, "Made");
  EXPECT_EQ(made.robot_file, "justin.urdf");
  ASSERT_EQ(made.observations.size(), 2U);
  EXPECT_EQ(made.observations[0].images[0], "images/left/l7.png") << "twins of two folders are kept apart";
  EXPECT_TRUE(std::filesystem::exists(folder.path / "made" / made.observations[0].images[1]));
  EXPECT_TRUE(made.observations[1].images[0].empty());
  EXPECT_TRUE(made.mount.estimate);
  EXPECT_FALSE(made.mount.known);
  EXPECT_TRUE(std::any_of(notes.begin(), notes.end(),
                          [](const std::string& n) { return n.find("l9.png has no partner") != std::string::npos; }));
  EXPECT_EQ(made.observations[1].position, parts().positions[1]);
}

/// One camera and a board: every image counts, and nothing waits for a label.
TEST_F(NewSessionTest, OfOneCameraAndABoardNothingIsToBeLabelled) {
  NewSession s = parts();
  s.rig.cameras.resize(1);
  s.rig.at(0).name = "front";
  s.images = find_images({folder.path / "a"});
  s.target = Target{.kind = TargetKind::chessboard, .columns = 6, .rows = 5, .square = 0.02};
  const Session made = make_session(s);
  ASSERT_TRUE(made.rig);
  EXPECT_EQ(made.rig->count(), 1);
  EXPECT_EQ(made.rig->at(0).name, "front");
  EXPECT_EQ(made.marker_count, 30);
  ASSERT_TRUE(made.target);
  EXPECT_DOUBLE_EQ(made.target->square, 0.02);
  EXPECT_EQ(made.observations[1].images[0], "images/l9.png");
  EXPECT_FALSE(needs_label(made));
}

TEST_F(NewSessionTest, OfThreeCamerasTheImagesThatAreThereCount) {
  NewSession s = parts();
  s.rig.cameras.push_back(s.rig.at(1));
  for (int i = 0; i < 3; ++i) s.rig.at(i).name = fmt::format("c{}", i);
  std::filesystem::create_directories(folder.path / "c");
  touch("c/l9.png");
  s.images = find_images({folder.path / "a", folder.path / "b", folder.path / "c"});
  ASSERT_EQ(s.images.size(), 2U);
  const Session made = make_session(s);
  EXPECT_EQ(made.observations[0].images[0], "images/c0/l7.png");
  EXPECT_EQ(made.observations[0].images[2], "");
  EXPECT_EQ(made.observations[1].images[1], "");
  EXPECT_EQ(made.observations[1].images[2], "images/c2/l9.png");
  s.folder = folder.path / "other";
  s.rig.cameras.pop_back();
  EXPECT_THROW(make_session(s), InputError) << "images of three cameras, a calibration of two";
}

/// Poses of another program in place of images.
TEST_F(NewSessionTest, PosesStandInPlaceOfImages) {
  NewSession s = parts();
  s.rig.cameras.clear();
  s.images.clear();
  s.target_poses = {Rigid{rotation_from_rpy(Vector3(0.1, 0.2, 0.3)), Vector3(0, 0.1, 0.8)}};
  EXPECT_THROW(make_session(s), InputError) << "one pose for two positions";
  s.target_poses.push_back(Rigid{rotation_from_rpy(Vector3(0.2, 0.2, 0.3)), Vector3(0.1, 0.1, 0.7)});
  const Session made = make_session(s);
  ASSERT_TRUE(made.pose_sensor);
  EXPECT_FALSE(made.rig);
  ASSERT_TRUE(made.observations[1].target_pose);
  EXPECT_TRUE(made.observations[1].target_pose->translation.isApprox(Vector3(0.1, 0.1, 0.7)));
  EXPECT_FALSE(needs_label(made));
}

TEST_F(NewSessionTest, WhatDoesNotFitIsRefusedBeforeAnythingIsWritten) {
  NewSession s = parts();
  s.positions.pop_back();
  EXPECT_THROW(make_session(s), InputError);
  EXPECT_FALSE(std::filesystem::exists(s.folder));
  s = parts();
  s.tcp = "third_hand";
  EXPECT_THROW(make_session(s), InputError);
  s = parts();
  s.rig.at(0).camera.width = 0;
  EXPECT_THROW(make_session(s), InputError);
  EXPECT_FALSE(std::filesystem::exists(s.folder));
  make_session(parts());
  EXPECT_THROW(make_session(parts()), InputError) << "a session that is there stays";
}

TEST_F(NewSessionTest, JointsOfATableAreThoseThatItNames) {
  const Robot robot = read_urdf(parts().urdf);
  replace_file(folder.path / "q.csv", "# a comment\nright_arm_2, time, \"torso_1\"\n1, 2, 3\n");
  EXPECT_EQ(joints_of_table(folder.path / "q.csv", robot), (std::vector<std::string>{"right_arm_2", "torso_1"}));
  replace_file(folder.path / "q.csv", "1, 2, 3\n");
  EXPECT_EQ(joints_of_table(folder.path / "q.csv", robot), joint_names(robot));
}

}  // namespace
}  // namespace handsight
