// SPDX-License-Identifier: Apache-2.0
// Denavit-Hartenberg parameters of a serial chain, exactly: the axes of its joints are lines in space, whatever frames
// the robot was described with.
#pragma once

#include <string>
#include <vector>

#include "robot/robot.h"

namespace handsight {

/// One joint. Craig's modified convention: Rx(alpha) Tx(a) Rz(theta + q) Tz(d) (Craig, Introduction to Robotics, 3.4);
/// the classical one: Rz(theta + q) Tz(d) Tx(a) Rx(alpha) (Denavit and Hartenberg 1955; Paul). A sliding joint adds q
/// to d. m and rad.
struct DhRow {
  int joint = 0;  // of the robot
  double a = 0, alpha = 0, d = 0, theta = 0;
};

/// root_from_link = base * product of the rows * tool.
struct DhChain {
  Rigid base, tool;
  std::vector<DhRow> rows;
};

/// Of the joints that move from the root to `link`, with the robot's own zeros. The first row of the modified table has
/// a = alpha = 0 and the last of the classical one too: base and tool take what no row can hold. Axes that are parallel
/// within 1e-12 rad share the common normal through the frame before. Springs are left out; a joint that follows others
/// has a row of its own.
DhChain modified_dh(const Robot& robot, int link);
DhChain classical_dh(const Robot& robot, int link);

/// The motion of a row with its joint at `value` (rad, m).
Rigid modified_motion(const DhRow& row, double value, bool slides);
Rigid classical_motion(const DhRow& row, double value, bool slides);

}  // namespace handsight
