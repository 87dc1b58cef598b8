// SPDX-License-Identifier: Apache-2.0
// What the effects of a model add to the numbers of a HandProgram.
#pragma once

#include <vector>

#include "correct/calibrated_robot.h"
#include "export/program_types.h"

namespace handsight {

/// Does an effect of the model make a joint or the root give way to loads?
bool bends(const CalibratedRobot& robot);

/// The robot's joints that formulas of the model read by name, wherever they are.
std::vector<int> joints_read_by_name(const CalibratedRobot& robot);

/// Adds the moves of all effects. `place`: of the robot's joints in the program, -1 for those that are not needed.
void add_moves(const CalibratedRobot& robot, const std::vector<int>& place, HandProgram& program);

}  // namespace handsight
