// SPDX-License-Identifier: Apache-2.0
// Poses, points and joint readings from tables and from easy_handeye.
#pragma once

#include <yaml-cpp/yaml.h>

#include <optional>
#include <string>
#include <vector>

#include "base/message.h"
#include "readers/series.h"
#include "readers/table.h"
#include "robot/robot.h"

namespace handsight {

/// Pairs of poses that easy_handeye (1 and 2) has sampled.
struct HandEyeSamples {
  std::vector<Rigid> base_from_effector, camera_from_target;
  bool eye_in_hand = true;
  bool kind_is_known = true;  // false: the file does not say where the camera is
};
bool is_hand_eye_samples(const YAML::Node& yaml);
HandEyeSamples read_hand_eye_samples(const YAML::Node& yaml, const std::string& file, std::vector<Message>& notes);

/// Triples of columns x y z (m1_x m1_y m1_z ...), or a line a point: x y z with marker and time or observation.
bool is_point_table(const Table& table);
PointSeries read_point_table(Table table, std::vector<Message>& notes);

/// The columns that name a joint of the robot that moves by itself ("a1", "a1_position", "position_a1", "A1"); where
/// none does as many numbered ones as the robot has such joints ("J1" ... "J6", "q0" ... "q5").
std::vector<std::size_t> list_joint_columns(const Table& table, const Robot& robot);

/// How many these are.
int joint_columns(const Table& table, const Robot& robot);

/// Joint readings. Without a header the columns are the robot's moving joints in their order, with a column of time
/// before them where there is one more. Degrees where the header says so or `degrees`; InputError where numbers can
/// only be degrees and nobody said so. Sentences in `notes`: what was taken for what, columns that would fit the limits
/// of other joints better.
JointSeries read_joint_table(Table table, const Robot& robot, bool degrees, std::vector<Message>& notes);

}  // namespace handsight
