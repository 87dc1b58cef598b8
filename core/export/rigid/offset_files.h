// SPDX-License-Identifier: Apache-2.0
// The zeros of the joints, for programs that correct nothing else.
#pragma once

#include "export/rigid/rigid_fit.h"

namespace handsight {

/// A <ros2_control> element for the robot's description: each joint with its command and state interface and a
/// parameter `offset` (rad, m): true angle = reading + offset.
std::string ros2_control_file(const CalibratedRobot& robot, const RigidFit& fit);

/// lerobot's calibration: id, drive_mode, homing_offset, range_min and range_max (ticks, 4096 a turn) of each joint.
/// The reading is to grow by the joint's offset; Feetech's motors subtract homing_offset from what they read (lerobot's
/// motors/feetech), so that it shrinks by as much. `before` is the text of the calibration that the arm was recorded
/// with, whose other numbers stay; empty: none, and homing_offset is what is to be added to its own. `fit` gets the
/// whole ticks, and what they miss. InputError where `before` is no such text or lacks a joint, or a joint slides.
std::string lerobot_file(const CalibratedRobot& robot, RigidFit& fit, const std::string& before);

}  // namespace handsight
