// SPDX-License-Identifier: Apache-2.0
// The kinematics as the ROS drivers of Universal Robots read them (kinematics_params_file).
#pragma once

#include "export/rigid/described_robot.h"

namespace handsight {

/// `kinematics:` with x, y, z, roll, pitch, yaw of shoulder, upper_arm, forearm, wrist_1, wrist_2 and wrist_3, each in
/// the one before, and a hash of these numbers. `robot` holds Holds::moving_origins. InputError where the robot has not
/// UR's six joints (with any prefix) one after another, or they do not turn about z as those of ur_description do.
std::string ur_file(const DescribedRobot& robot);

}  // namespace handsight
