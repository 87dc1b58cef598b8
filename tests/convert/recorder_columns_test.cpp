// SPDX-License-Identifier: Apache-2.0
// Tables as `rostopic echo -p` and UR's RTDE write them.
#include "convert/recorder_columns.h"

#include <gmock/gmock.h>

namespace handsight {
namespace {

using testing::ElementsAre;

std::vector<std::string> list_names(const Table& table) {
  std::vector<std::string> names;
  for (const TableColumn& column : table.columns) names.push_back(column.name);
  return names;
}

TEST(RecorderColumns, JointsOfRostopicAreCalledByTheirNames) {
  const auto table = parse_recorded_table(
      "%time,field.header.seq,field.header.frame_id,field.name0,field.name1,field.position0,field.position1\n"
      "1700000000000000000,1,,a1,a2,0.25,0.5\n1700000001000000000,2,,a1,a2,0.5,0.75\n",
      "joints.csv");
  ASSERT_TRUE(table);
  EXPECT_THAT(list_names(*table), ElementsAre("time", "header.seq", "header.frame_id", "name0", "name1", "a1", "a2"));
  EXPECT_EQ(table->rows[1][6], 0.75);
  for (const TableColumn& column : table->columns) EXPECT_TRUE(column.words.empty()) << column.name;
  std::vector<Message> notes;
  const std::vector<double> times = list_times(*table, notes);
  EXPECT_NEAR(times[1] - times[0], 1, 1e-6);
}

TEST(RecorderColumns, PosesOfRtdeAreRotationVectors) {
  const auto table = parse_recorded_table(
      "timestamp actual_TCP_pose_0 actual_TCP_pose_1 actual_TCP_pose_2 actual_TCP_pose_3 actual_TCP_pose_4 "
      "actual_TCP_pose_5\n0.1 1 2 3 0.1 0.2 0.3\n",
      "robot_data.csv");
  ASSERT_TRUE(table);
  EXPECT_THAT(list_names(*table), ElementsAre("timestamp", "x", "y", "z", "rvx", "rvy", "rvz"));
  EXPECT_EQ(table->columns[4].unit, "rad");
}

TEST(RecorderColumns, OtherTablesStayAsTheyAre) {
  const auto table = parse_recorded_table("time,field.x,actual_TCP_pose_0\n1,2,3\n", "some.csv");
  ASSERT_TRUE(table);
  EXPECT_THAT(list_names(*table), ElementsAre("time", "field.x", "actual_TCP_pose_0"));
}

}  // namespace
}  // namespace handsight
