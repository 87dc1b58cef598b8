// SPDX-License-Identifier: Apache-2.0
// Poses of which each is a file or an entry of its own: matrices as text, ViSP's vectors, OpenCV's storages.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/message.h"
#include "readers/pose_table.h"

namespace handsight {

/// The one pose that a text holds: a 4x4 matrix (four rows, brackets or not, or OpenCV's), or the six numbers of a ViSP
/// pose vector (place and rotation vector). Nothing where it holds something else.
std::optional<Rigid> single_pose(const std::string& text);

/// The pose files of a folder; empty where there is none.
std::vector<std::filesystem::path> pose_files_in(const std::filesystem::path& folder);

/// Files of one pose each, in the order of the last number in their names; what stands before it says of what they are
/// ("pose_fPe_1.yaml", "pose_cPo_1.yaml"). InputError where one is no pose or a number is there twice.
std::vector<ReadPoses> read_pose_files(const std::vector<std::filesystem::path>& files, const std::string& what,
                                       std::vector<Message>& notes);

/// The poses of an OpenCV storage: entries of 4x4 that are numbered ("gripper2base01"), or R and t of each ("R_01",
/// "t_01"). Empty where it holds fewer than two.
std::vector<ReadPoses> poses_of_storage(const std::string& text, const std::string& file, std::vector<Message>& notes);

}  // namespace handsight
