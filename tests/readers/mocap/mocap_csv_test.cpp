// SPDX-License-Identifier: Apache-2.0
// Motion capture as Motive, Vicon's programs and QTM export it.
#include "readers/mocap/mocap_csv.h"

#include <gmock/gmock.h>

#include <cmath>

#include "readers/pose_files.h"
#include "readers/pose_table.h"
#include "session/session_texts.h"

namespace handsight {
namespace {

using testing::Contains;
using testing::HasSubstr;

/// Two bodies with their markers, one marker by itself; the second body is lost in the second frame.
std::string motive(const std::string& rotation = "Quaternion") {
  return "Format Version,1.23,Take Name,Take 1,Capture Frame Rate,120.000000,Rotation Type," + rotation +
         ",Length Units,Millimeters,Coordinate Space,Global\r\n\r\n"
         ",Type,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body "
         "Marker,"
         "Rigid Body Marker,Rigid Body Marker,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid "
         "Body,"
         "Marker,Marker,Marker\r\n"
         ",Name,hand,hand,hand,hand,hand,hand,hand,hand,hand:Marker1,hand:Marker1,hand:Marker1,base,base,base,base,"
         "base,base,"
         "base,tip,tip,tip\r\n"
         ",ID,1,1,1,1,1,1,1,1,2,2,2,3,3,3,3,3,3,3,4,4,4\r\n"
         ",,Rotation,Rotation,Rotation,Rotation,Position,Position,Position,Mean Marker "
         "Error,Position,Position,Position,"
         "Rotation,Rotation,Rotation,Rotation,Position,Position,Position,Position,Position,Position\r\n"
         "Frame,Time (Seconds),X,Y,Z,W,X,Y,Z,,X,Y,Z,X,Y,Z,W,X,Y,Z,X,Y,Z\r\n"
         "0,0.000000,0,0,0.6,0.8,100,200,300,0.1,1,2,3,0,0,0,1,10,20,30,7,8,9\r\n"
         "1,0.008333,0,0,0,1,101,201,301,0.1,1,2,3,,,,,,,,7,8,10\r\n";
}

TEST(MocapCsv, MotivesRigidBodies) {
  ASSERT_TRUE(is_motive_csv(motive()));
  std::vector<Message> notes;
  const MocapTables all = read_motive_csv(motive(), "take.csv");
  ASSERT_EQ(all.bodies.size(), 2u);
  EXPECT_EQ(all.bodies[0].name, "hand");
  EXPECT_THAT(all.notes, Contains(HasSubstr("2 markers beside the rigid bodies are left out")));
  const auto hand = read_pose_table(all.bodies[0].table, true, {}, notes),
             base = read_pose_table(all.bodies[1].table, true, {}, notes);
  ASSERT_EQ(hand.at(0).series.poses.size(), 2u);
  EXPECT_LT((hand[0].series.poses[0].translation - Vector3(0.1, 0.2, 0.3)).norm(), 1e-12);
  EXPECT_LT((vector_from_rotation(hand[0].series.poses[0].rotation) - Vector3(0, 0, 2 * std::asin(0.6))).norm(), 1e-12);
  EXPECT_NEAR(hand[0].series.times[1] - hand[0].series.times[0], 0.008333, 1e-9);
  EXPECT_EQ(base.at(0).series.poses.size(), 1u) << "where it was not seen it has no pose";
  EXPECT_THAT(find_refusal([] { read_motive_csv(motive("XYZ"), "take.csv"); }), HasSubstr("rotation type Quaternion"));
  EXPECT_THAT(find_refusal([] { read_motive_csv("Format Version,1.23\nFrame,Time\n", "take.csv"); }),
              HasSubstr("header"));
}

TEST(MocapCsv, MotivesMarkersWhereThereIsNoBody) {
  const std::string text =
      "Format Version,1.23,Length Units,Meters\n,Type,Marker,Marker,Marker,Marker,Marker,Marker\n"
      ",Name,a,a,a,Unlabeled 12,Unlabeled 12,Unlabeled 12\n,ID,1,1,1,2,2,2\n"
      ",,Position,Position,Position,Position,Position,Position\nFrame,Time (Seconds),X,Y,Z,X,Y,Z\n"
      "0,0.0,0.1,0.2,0.3,9,9,9\n1,0.01,0.1,,0.3,9,9,9\n";
  std::vector<Message> notes;
  MocapTables all = read_motive_csv(text, "take.csv");
  EXPECT_TRUE(all.bodies.empty());
  const PointSeries points = read_point_table(std::move(all.markers), notes);
  ASSERT_EQ(points.points.size(), 2u);
  ASSERT_EQ(points.points[0].size(), 1u);
  EXPECT_LT((*points.points[0][0] - Vector3(0.1, 0.2, 0.3)).norm(), 1e-12);
  EXPECT_FALSE(points.points[1][0].has_value());
}

TEST(MocapCsv, ViconsObjectsWithQuaternionsOrAngles) {
  const std::string quaternions =
      "Objects\n200\n,,Global Angle wand:wand,,,,,,\nFrame,Sub Frame,RX,RY,RZ,RW,TX,TY,TZ\n,,,,,,mm,mm,mm\n"
      "1,0,0,0,0.6,0.8,100,200,300\n3,0,0,0,0,1,110,200,300\n\n";
  ASSERT_TRUE(is_vicon_csv(quaternions));
  std::vector<Message> notes;
  MocapTables all = read_vicon_csv(quaternions, "vicon.csv");
  ASSERT_EQ(all.bodies.size(), 1u);
  EXPECT_EQ(all.bodies[0].name, "wand");
  auto wand = read_pose_table(all.bodies[0].table, true, {}, notes);
  ASSERT_EQ(wand.at(0).series.poses.size(), 2u);
  EXPECT_LT((wand[0].series.poses[1].translation - Vector3(0.11, 0.2, 0.3)).norm(), 1e-12);
  EXPECT_NEAR(wand[0].series.times[1] - wand[0].series.times[0], 0.01, 1e-9) << "two frames of 200 Hz";
  const std::string angles =
      "Segments\n100\n,,arm:hand,,,,,\nFrame,Sub Frame,RX,RY,RZ,TX,TY,TZ\n,,deg,deg,deg,mm,mm,mm\n"
      "1,0,10,20,90,100,200,300\n2,0,11,21,91,100,200,300\n";
  all = read_vicon_csv(angles, "vicon.csv");
  wand = read_pose_table(all.bodies.at(0).table, true, {}, notes);
  EXPECT_GE(wand.at(0).turns.readings.size(), 2u) << "rotation vector or fixed axes: the poses decide";
  for (const TurnReading& reading : wand[0].turns.readings) EXPECT_TRUE(reading.degrees);
}

TEST(MocapCsv, ViconsTrajectoriesBesideOtherSections) {
  const std::string text =
      "Devices\n1000\n,,Force\nFrame,Sub Frame,Fx\n,,N\n1,0,5\n\n"
      "Trajectories\n100\n,,hand:m1,,,hand:m2,,\nFrame,Sub Frame,X,Y,Z,X,Y,Z\n,,mm,mm,mm,mm,mm,mm\n"
      "1,0,1,2,3,4,5,6\n2,0,1,2,3,,,\n";
  std::vector<Message> notes;
  MocapTables all = read_vicon_csv(text, "vicon.csv");
  EXPECT_THAT(all.notes, Contains(HasSubstr("\"Devices\" is left out")));
  const PointSeries points = read_point_table(std::move(all.markers), notes);
  ASSERT_EQ(points.points.size(), 2u);
  EXPECT_LT((*points.points[0][1] - Vector3(4e-3, 5e-3, 6e-3)).norm(), 1e-12);
  EXPECT_FALSE(points.points[1][1].has_value());
}

/// Two bodies of QTM, of which the second is lost in the second frame; a turn of 30 degrees about z, then of 90 about
/// x.
std::string qualisys(const std::string& after_names = "") {
  const std::string lost = "\t0.000\t0.000\t0.000\t0\t0\t0\t-1\t0\t0\t0\t0\t0\t0\t0\t0\t0";
  const std::string about_z = "\t100.5\t200\t300\t0\t0\t30\t0.2\t0.8660254\t0.5\t0\t-0.5\t0.8660254\t0\t0\t0\t1";
  const std::string about_x = "\t1\t2\t3\t90\t0\t0\t0.2\t1\t0\t0\t0\t0\t1\t0\t-1\t0";
  return "NO_OF_FRAMES\t2\r\nNO_OF_CAMERAS\t8\r\nNO_OF_BODIES\t2\r\nFREQUENCY\t100\r\nTIME_STAMP\t2024-03-01, "
         "10:00:00\t12.5\r\nDATA_INCLUDED\t6D\r\nBODY_NAMES\thand\tbase\t\r\n" +
         after_names + "1\t0.00000" + about_z + about_x + "\t\r\n2\t0.01000" + about_x + lost + "\t\r\n";
}

TEST(MocapCsv, QualisysBodies) {
  const std::string header = "Frame\tTime\thand X\tY\tZ\tRoll\tPitch\tYaw\tResidual\tRot[0]\tRot[1]\r\n";
  for (const std::string& text : {qualisys(), qualisys(header)}) {
    ASSERT_TRUE(is_qualisys_tsv(text));
    std::vector<Message> notes;
    const auto all = read_mocap(text, "take_6D.tsv");
    ASSERT_EQ(all->bodies.size(), 2u);
    EXPECT_EQ(all->bodies[0].name, "hand");
    const auto hand = read_pose_table(all->bodies[0].table, true, {}, notes),
               base = read_pose_table(all->bodies[1].table, true, {}, notes);
    ASSERT_EQ(hand.at(0).series.poses.size(), 2u);
    EXPECT_LT((hand[0].series.poses[0].translation - Vector3(0.1005, 0.2, 0.3)).norm(), 1e-12);
    EXPECT_LT((vector_from_rotation(hand[0].series.poses[0].rotation) - Vector3(0, 0, M_PI / 6)).norm(), 1e-6);
    EXPECT_LT((vector_from_rotation(hand[0].series.poses[1].rotation) - Vector3(M_PI / 2, 0, 0)).norm(), 1e-6);
    EXPECT_NEAR(hand[0].series.times[1] - hand[0].series.times[0], 0.01, 1e-9);
    EXPECT_EQ(base.at(0).series.poses.size(), 1u) << "where it was not seen it has no pose";
  }
  std::string cut = qualisys();
  cut.replace(cut.find("\t0.2\t0.866"), 4, "");
  EXPECT_THAT(find_refusal([&] { read_mocap(cut, "take_6D.tsv"); }), HasSubstr("16 columns"));
}

/// Without frames' numbers and times: the rate tells.
TEST(MocapCsv, QualisysMarkers) {
  const std::string text =
      "FILE_VERSION\t2.0.0\nNO_OF_FRAMES\t2\nNO_OF_MARKERS\t2\nFREQUENCY\t50\nDATA_INCLUDED\t3D\nEVENT\tstart\t1\t0.0\n"
      "MARKER_NAMES\tm1\tm2\nTRAJECTORY_TYPES\tMeasured\tMeasured\n1\t2\t3\t40\t50\t60\n1.5\t2\t3\t0.000\t0.000\t0."
      "000\n";
  ASSERT_TRUE(is_mocap(text));
  std::vector<Message> notes;
  const PointSeries points = read_point_table(read_mocap(text, "take.tsv")->markers, notes);
  ASSERT_EQ(points.points.size(), 2u);
  ASSERT_EQ(points.points[0].size(), 2u);
  EXPECT_LT((*points.points[0][1] - Vector3(0.04, 0.05, 0.06)).norm(), 1e-12);
  EXPECT_FALSE(points.points[1][1]) << "zeros are what was not seen";
  EXPECT_NEAR(points.times[1], 0.02, 1e-12);
}

}  // namespace
}  // namespace handsight
