// SPDX-License-Identifier: Apache-2.0
// The robot's file beside a calibration: what exporters write anew.
#pragma once

#include "correct/calibrated_robot.h"

namespace handsight {

/// With the text of that URDF and the folder from which its meshes are named. Unchanged where there is no such file:
/// what needs the text then says so. InputError where it cannot be read.
CalibratedRobot with_robot_file(CalibratedRobot robot, const std::filesystem::path& urdf);

/// With the session's own (of several joined: the first's).
CalibratedRobot with_robot_file(CalibratedRobot robot, const Session& session);

}  // namespace handsight
