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

/// The poses that a text of one instant holds, by what it calls them ("" where it is one pose): a 4x4 matrix (four
/// rows, brackets or not, OpenCV's or Zivid's), the six numbers of a ViSP pose vector (place and rotation vector), a
/// pose of HALCON's, or a map of YAML or JSON with poses under names of their own ("O_T_EE", "target_rvec" and
/// "target_tvec"). Empty where it holds something else.
std::vector<std::pair<std::string, Rigid>> poses_of_instant(const std::string& text);

/// The pose files of a folder, or of its numbered folders ("pose_00/data.json"); empty where there is none.
std::vector<std::filesystem::path> pose_files_in(const std::filesystem::path& folder);

/// Files of one instant each, in the order of the last number in their names (else of their folder's); what stands
/// before it says of what they are ("pose_fPe_1.yaml", "pose_cPo_1.yaml"), where the file itself does not. InputError
/// where one is no pose or a number is there twice.
std::vector<ReadPoses> read_pose_files(const std::vector<std::filesystem::path>& files, const std::string& what,
                                       std::vector<Message>& notes);

/// The poses of an OpenCV storage: entries of 4x4 that are numbered ("gripper2base01"), or R and t of each ("R_01",
/// "t_01"). Empty where it holds fewer than two.
std::vector<ReadPoses> poses_of_storage(const std::string& text, const std::string& file, std::vector<Message>& notes);

/// Poses of an OpenCV storage as a table of places and turns, without a header: numbered entries of six or seven
/// numbers
/// ("pose1: [...]"), or a list of rotation vectors and one of places. Nothing where it holds fewer than two, or a
/// 3x3 matrix, as cameras have.
std::optional<Table> pose_rows_of_storage(const std::string& text, const std::string& file);

}  // namespace handsight
