// SPDX-License-Identifier: Apache-2.0
// The <collision> shapes of a URDF, which Robot leaves out: it holds what is drawn.
#pragma once

#include <string>
#include <vector>

#include "robot/robot.h"

namespace handsight {

/// By link of the robot: its <collision> shapes, else its <visual> ones, else none. `text` is the URDF that the robot
/// was read from, `file_name` what sentences call it; links that the text does not have keep their visual shapes.
std::vector<std::vector<Shape>> collision_shapes(const Robot& robot, const std::string& text,
                                                 const std::string& file_name);

/// The visual shapes alone, by link: for a robot without a text.
std::vector<std::vector<Shape>> visual_shapes(const Robot& robot);

}  // namespace handsight
