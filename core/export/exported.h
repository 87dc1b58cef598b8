// SPDX-License-Identifier: Apache-2.0
// A calibrated robot as a file of another kind.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/message.h"
#include "correct/calibrated_robot.h"

namespace handsight {

inline constexpr std::array export_kinds{"urdf",           "xacro",     "mjcf", "sdf",    "dh",
                                         "ur_calibration", "yaml",      "csv",  "opencv", "lerobot",
                                         "ros2_control",   "static_tf", "cpp",  "python"};

/// Of a kind: the ending of its files, with the dot and none of a calibration's own, and its name in every language.
struct ExportKind {
  const char *ending, *title;
};
ExportKind export_kind(const std::string& kind);

struct ExportOptions {
  /// The file that will be written: meshes are named from its folder, a table is CSV where it ends in .csv. Empty:
  /// standard output.
  std::filesystem::path file;
  std::string lerobot;  // the text of the calibration that lerobot recorded with; empty: none
};

struct ExportedFile {
  std::string text;
  std::vector<Message> notes;  // what the file does not say, a sentence each
  /// How far its hand is from where the whole calibration has it, m, over the session's poses: rms and at most; and the
  /// robot's as it was written. Nothing where no joint is known, or the file says where sensor and target sit alone.
  std::optional<double> left, largest_left, nominal;
  int poses = 0;
};

/// `kind` is one of export_kinds. InputError where it is not, or the robot cannot be written so.
ExportedFile exported_file(const CalibratedRobot& robot, const std::string& kind, const ExportOptions& options = {});

}  // namespace handsight
