// SPDX-License-Identifier: Apache-2.0
// Poses from YAML and JSON.
#pragma once

#include <yaml-cpp/yaml.h>

#include <optional>
#include <string>
#include <vector>

#include "base/message.h"
#include "readers/pose_table.h"

namespace handsight {

/// The pose that a node tells: {position, orientation} under the names of ROS and of people, or a matrix of 4x4 (16
/// numbers row by row, or four lists of four). Nothing where it is none; InputError where it is one that cannot be.
std::optional<Rigid> find_pose(const YAML::Node& node, const std::string& file, std::size_t number);

/// The same; InputError where there is none.
Rigid required_pose(const YAML::Node& node, const std::string& file, std::size_t number);

/// A rotation of 9 numbers row by row and a place of 3; nothing where these make no rigid motion.
std::optional<Rigid> rigid_of_parts(const std::vector<double>& rotation, const std::vector<double>& place);

/// A matrix of 16 numbers row by row or column by column, or of its first three rows; nothing where these make no rigid
/// motion.
std::optional<Rigid> rigid_of_numbers(const std::vector<double>& numbers);

/// Millimetres where lengths can be nothing else, with a sentence.
void bring_to_metres(PoseSeries& series, const std::string& file, std::vector<Message>& notes);

/// Lists of poses as ROS, MoveIt and people write them in YAML or JSON: of {position, orientation} (also translation,
/// rotation; xyz, quaternion; R, t), of matrices (16 numbers, or four lists of four), or of pairs of them, each of its
/// own name ("effector_wrt_world", "object_wrt_sensor"); lists of rotations and of places ("R_gripper2base",
/// "t_gripper2base").
bool is_pose_list(const YAML::Node& yaml);

/// One series, or two: the flange's first where nothing names them. InputError where a pose is not whole.
std::vector<ReadPoses> read_pose_list(const YAML::Node& yaml, const std::string& file, std::vector<Message>& notes);

}  // namespace handsight
