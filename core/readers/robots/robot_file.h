// SPDX-License-Identifier: Apache-2.0
// Robots as files of several kinds: URDF, xacro and MuJoCo's MJCF.
#pragma once

#include <filesystem>
#include <string>

#include "readers/field_urdf.h"

namespace handsight {

/// Is this text the file of a robot?
bool is_robot_text(const std::string& text);

/// The robot of a file, as `field_urdf` has it. xacro is expanded by the program `xacro` where it is installed.
/// InputError where the file is no robot, or of xacro and the program is not there or fails.
FieldUrdf robot_of_file(const std::filesystem::path& path);

}  // namespace handsight
