// SPDX-License-Identifier: Apache-2.0
// What arrives in a folder: whole lines and images alone, each once, whoever starts again.
#include "live/arrivals.h"

#include <gmock/gmock.h>

#include <thread>

#include "fixtures/robots_with_everything.h"
#include "session/pose_points.h"

namespace handsight {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class ArrivalsInAFolder : public testing::Test {
 protected:
  void append(const std::string& name, const std::string& text) {
    std::filesystem::create_directories((folder.path / name).parent_path());
    std::ofstream(folder.path / name, std::ios::app | std::ios::binary) << text;
  }
  Session tracker() {
    Session s = fixture::tracker_session(1);
    s.file = folder.path / "session.xml";
    s.observations.clear();
    return s;
  }
  Session cameras() {
    Session s = fixture::stand_session(3);
    s.file = folder.path / "session.xml";
    for (RigCamera& c : s.rig->cameras) c.camera.width = 8, c.camera.height = 6;
    s.observations.clear();
    return s;
  }
  const std::string image = "P5\n8 6\n255\n" + std::string(48, 'x');
  static constexpr char header[] = "number,time,a1,a2,a3,a4,a5,a6\n";
  TemporaryFolder folder;
};

TEST_F(ArrivalsInAFolder, PosesAndPointsMeetByTheirNumbersWhoeverComesFirst) {
  Arrivals arrivals(tracker());
  EXPECT_THAT(arrivals.look().arrived, IsEmpty());
  append("joints.csv", header);
  append("joints.csv", "7,1.5,0.1,0.2,0.3,0.4,0.5,0.6\n");
  EXPECT_THAT(arrivals.look().arrived, IsEmpty()) << "what was measured is not there yet";
  append("points.csv", "number,m0_x,m0_y,m0_z\n8,4,5,6\n7,1,2,3\n");
  const Arrivals::Look first = arrivals.look();
  ASSERT_THAT(first.arrived, SizeIs(1));
  EXPECT_EQ(first.arrived[0].time, 1.5);
  EXPECT_EQ(first.arrived[0].position[4], 0.5);
  EXPECT_EQ(*first.arrived[0].sightings[0].point, Vector3(1, 2, 3));
  append("joints.csv", "8,2.5,0,0,0,0,0,0\n");
  ASSERT_THAT(arrivals.look().arrived, SizeIs(1));
  EXPECT_THAT(arrivals.look().arrived, IsEmpty()) << "each comes once";
}

TEST_F(ArrivalsInAFolder, HalfALineWaitsAndABrokenOneIsSetAside) {
  Arrivals arrivals(tracker());
  append("points.csv", "number,m0_x,m0_y,m0_z\n1,1,2,3\n2,1,2,3\n3,1,2,3\n");
  append("joints.csv", std::string(header) + "1,1,0.1,0.2,0.3,0.4,0.");
  EXPECT_THAT(arrivals.look().arrived, IsEmpty());
  append("joints.csv", "5,0.6\n");
  const Arrivals::Look whole = arrivals.look();
  ASSERT_THAT(whole.arrived, SizeIs(1));
  EXPECT_EQ(whole.arrived[0].position[4], 0.5);
  append("joints.csv", "2,2,0.1,0.2\n3,3,0.1,nan,0,0,0,0\n");
  const Arrivals::Look broken = arrivals.look();
  EXPECT_THAT(broken.arrived, IsEmpty());
  EXPECT_THAT(broken.remarks, ElementsAre(HasSubstr("4 columns"), HasSubstr("finite number")));
  append("joints.csv", "3,3,0.1,0.2,0,0,0,0\n");
  EXPECT_THAT(arrivals.look().arrived, SizeIs(1)) << "said again, and right";
}

TEST_F(ArrivalsInAFolder, EitherSideMayStartAgain) {
  append("joints.csv", std::string(header) + "1,1,0,0,0,0,0,0\n2,2,0,0,0,0,0,0\n");
  append("points.csv", "number,m0_x,m0_y,m0_z\n1,1,2,3\n2,1,2,3\n");
  Session session = tracker();
  {
    Arrivals arrivals(session);
    session.observations = arrivals.look().arrived;
    ASSERT_THAT(session.observations, SizeIs(2));
  }
  Arrivals again(session);  // the reader was started again with what it had saved
  EXPECT_THAT(again.look().arrived, IsEmpty());
  std::ofstream(folder.path / "joints.csv") << header << "1,3,0,0,0,0,0,1\n";  // the writer was
  std::ofstream(folder.path / "points.csv") << "number,m0_x,m0_y,m0_z\n1,1,2,3\n";
  EXPECT_THAT(again.look().arrived, SizeIs(1));
}

TEST_F(ArrivalsInAFolder, ImagesAreTakenWhole) {
  Arrivals arrivals(cameras());
  append("joints.csv", std::string(header) + "12,1,0,0,0,0,0,0\n");
  append("images/cam_012_left.pgm", image);
  EXPECT_THAT(arrivals.look().arrived, IsEmpty());
  append("images/cam_012_right.pgm", image.substr(0, 30));
  EXPECT_THAT(arrivals.look().arrived, IsEmpty());
  append("images/cam_012_right.pgm", image.substr(30));
  const Arrivals::Look look = arrivals.look();
  ASSERT_THAT(look.arrived, SizeIs(1));
  EXPECT_EQ(look.arrived[0].images[0], "images/cam_012_left.pgm");
  EXPECT_EQ(look.arrived[0].images[1], "images/cam_012_right.pgm");
}

TEST_F(ArrivalsInAFolder, AnImageThatStaysHalfIsSetAsideWithASentence) {
  Arrivals arrivals(cameras());
  append("joints.csv", std::string(header) + "1,1,0,0,0,0,0,0\n2,2,0,0,0,0,0,0\n");
  append("images/001_left.pgm", image);
  append("images/001_right.pgm", "P5\n8 6\n255\nxx");
  append("images/002_left.pgm", image);
  append("images/002_right.pgm", image);
  EXPECT_THAT(arrivals.look().arrived, SizeIs(1)) << "one that is broken holds up no other";
  std::this_thread::sleep_for(std::chrono::milliseconds(2100));
  EXPECT_THAT(arrivals.look().remarks, ElementsAre(HasSubstr("001_right.pgm is set aside")));
  EXPECT_THAT(arrivals.look().remarks, IsEmpty()) << "said once";
}

TEST_F(ArrivalsInAFolder, ImagesGoToTheCameraThatTheirNameNames) {
  Session session = cameras();
  session.rig->at(0).name = "cam1";
  session.rig->at(1).name = "cam12";
  Arrivals arrivals(session);
  append("joints.csv", std::string(header) + "7,1,0,0,0,0,0,0\n");
  append("images/0007_cam12.pgm", image);
  EXPECT_THAT(arrivals.look().arrived, IsEmpty()) << "cam1 has none yet";
  append("images/cam1_0007.pgm", image);
  const Arrivals::Look look = arrivals.look();
  ASSERT_THAT(look.arrived, SizeIs(1));
  EXPECT_EQ(look.arrived[0].images[0], "images/cam1_0007.pgm");
  EXPECT_EQ(look.arrived[0].images[1], "images/0007_cam12.pgm");
}

TEST_F(ArrivalsInAFolder, OfOneCameraAnyNameWithANumberWillDo) {
  Session session = cameras();
  session.rig->cameras.resize(1);
  Arrivals arrivals(session);
  append("joints.csv", std::string(header) + "12,1,0,0,0,0,0,0\n");
  append("images/frame 0012.pgm", image);
  const Arrivals::Look look = arrivals.look();
  ASSERT_THAT(look.arrived, SizeIs(1));
  EXPECT_EQ(look.arrived[0].images[0], "images/frame 0012.pgm");
}

TEST_F(ArrivalsInAFolder, PosesOfATargetComeWhole) {
  Session session = tracker();
  session.pose_sensor = PoseSensor{};
  show_poses(session, pose_lever(*session.pose_sensor));
  Arrivals arrivals(session);
  append("joints.csv", std::string(header) + "1,1,0,0,0,0,0,0\n2,2,0,0,0,0,0,0\n");
  append("poses.csv", "number,x,y,z,qx,qy,qz,qw\n1,0.1,0.2,0.3,0,0,0.6,0.8\n2,0.1,0.2,0.3,0,0,0,0\n");
  const Arrivals::Look look = arrivals.look();
  ASSERT_THAT(look.arrived, SizeIs(1));
  ASSERT_TRUE(look.arrived[0].target_pose.has_value());
  EXPECT_EQ(look.arrived[0].target_pose->translation, Vector3(0.1, 0.2, 0.3));
  EXPECT_NEAR(look.arrived[0].target_pose->rotation(0, 0), 1 - 2 * 0.36, 1e-12);
  EXPECT_THAT(look.arrived[0].sightings, SizeIs(pose_markers));
  EXPECT_THAT(look.remarks, ElementsAre(HasSubstr("length 1")));
}

/// Whoever looks anew, with what had arrived in the session: without times too nothing comes twice.
TEST_F(ArrivalsInAFolder, WhatHasArrivedDoesNotComeAgain) {
  Session session = tracker();
  session.pose_sensor = PoseSensor{};
  show_poses(session, pose_lever(*session.pose_sensor));
  std::string without_time = header;
  without_time.erase(without_time.find("time,"), 5);
  append("joints.csv", without_time + "1,0,0.1,0,0,0,0\n2,0,0.2,0,0,0,0\n");
  append("poses.csv", "number,x,y,z,qx,qy,qz,qw\n1,0.1,0.2,0.3,0,0,0.6,0.8\n2,0.1,0.2,0.3,0,0,0.6,0.8\n");
  const Arrivals::Look first = Arrivals(session).look();
  ASSERT_THAT(first.arrived, SizeIs(2)) << "another posture in which the same was measured is another observation";
  session.observations = first.arrived;
  Arrivals anew(session);
  EXPECT_THAT(anew.look().arrived, IsEmpty());
  append("joints.csv", "3,0,0.3,0,0,0,0\n");
  append("poses.csv", "3,0.1,0.2,0.3,0,0,0.6,0.8\n");
  EXPECT_THAT(anew.look().arrived, SizeIs(1));
}

/// Where no more is known of the robot than where its flange is, joints.csv says that.
TEST_F(ArrivalsInAFolder, PosesOfTheFlangeInPlaceOfJoints) {
  Session session = tracker();
  session.robot = poses_robot();
  session.joints = {"flange_x", "flange_y", "flange_z", "flange_yaw", "flange_pitch", "flange_roll"};
  session.pose_sensor = PoseSensor{};
  show_poses(session, pose_lever(*session.pose_sensor));
  Arrivals arrivals(session);
  append("joints.csv", "number,x,y,z,qx,qy,qz,qw\n1,0.4,0.5,0.6,0,0.6,0,0.8\n2,0.4,0.5,0.6,0,0.6,0,0.1\n");
  append("poses.csv", "number,x,y,z,qx,qy,qz,qw\n1,0.1,0.2,0.3,0,0,0.6,0.8\n2,0.1,0.2,0.3,0,0,0.6,0.8\n");
  const Arrivals::Look look = arrivals.look();
  ASSERT_THAT(look.arrived, SizeIs(1));
  const Rigid flange = base_from_flange(look.arrived[0].position);
  EXPECT_LT((flange.translation - Vector3(0.4, 0.5, 0.6)).norm(), 1e-15);
  EXPECT_LT((flange.rotation - Eigen::Quaterniond(0.8, 0, 0.6, 0).toRotationMatrix()).norm(), 1e-14);
  EXPECT_THAT(look.remarks, ElementsAre(HasSubstr("pose of the flange")));
}

}  // namespace
}  // namespace handsight
