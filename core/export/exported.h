// SPDX-License-Identifier: Apache-2.0
// A calibrated robot as a file of another kind.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "correct/calibrated_robot.h"

namespace handsight {

inline constexpr std::array export_kinds{"urdf", "yaml", "static_tf", "opencv", "cpp", "python", "csv"};

struct ExportedFile {
  std::string text;
  std::vector<std::string> notes;  // what the file does not say, a sentence each
};

/// `kind` is one of export_kinds. InputError where it is not, or the robot cannot be written so.
ExportedFile exported_file(const CalibratedRobot& robot, const std::string& kind);

}  // namespace handsight
