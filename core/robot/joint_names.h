// SPDX-License-Identifier: Apache-2.0
// A robot's joints by name, as sentences list them.
#pragma once

#include <string>

#include "robot/robot.h"

namespace handsight {

/// "axis_1, axis_2, axis_3", shortened where there are many; "none" where nothing moves.
std::string list_moving_joints(const Robot& robot);

}  // namespace handsight
