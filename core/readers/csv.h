// SPDX-License-Identifier: Apache-2.0
// Poses from a table of text.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/message.h"

namespace handsight {

/// What stands in a line of a table between commas, semicolons or white space (one kind a line), without what follows a
/// '#'; views into `line`. None where nothing stands in it; the last is empty where the line ends with a separator, as
/// many programs have it.
std::vector<std::string_view> cells_of_line(std::string_view line);

/// Does a line name columns: is none of its cells a number?
bool names_columns(const std::vector<std::string_view>& cells);

/// Poses and what is known of how the robot comes there.
struct PoseTable {
  std::vector<Eigen::VectorXd> positions;   // rad or m, each in the order of `joints`
  std::vector<Eigen::VectorXd> velocities;  // rad/s or m/s, one a position, 0 where a joint has no column; or empty
  std::vector<double> times;                // s, one a position; or empty
};

/// As parse_poses; columns named "time" and "velocity_JOINT" are read too where a header has them.
PoseTable parse_pose_table(const std::string& text, const std::string& file, const std::vector<std::string>& joints,
                           std::vector<Message>* notes = nullptr);
PoseTable read_pose_table(const std::filesystem::path& path, const std::vector<std::string>& joints,
                          std::vector<Message>* notes = nullptr);

/// Positions, each in the order of `joints` (rad or m), from lines of numbers separated by commas, semicolons
/// or white space (one kind a line); what follows a '#' and empty lines are left out. A first line that is
/// not of numbers is a header: it names every joint once, in any order; other columns are ignored, with a
/// sentence in `notes`. Without a header the columns are `joints`. InputError with the line's number where a
/// line is wrong, or where there is no pose.
std::vector<Eigen::VectorXd> parse_poses(const std::string& text, const std::string& file,
                                         const std::vector<std::string>& joints, std::vector<Message>* notes = nullptr);
std::vector<Eigen::VectorXd> read_poses(const std::filesystem::path& path, const std::vector<std::string>& joints,
                                        std::vector<Message>* notes = nullptr);

}  // namespace handsight
