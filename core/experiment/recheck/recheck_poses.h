// SPDX-License-Identifier: Apache-2.0
// The poses in which a calibrated robot is looked at again.
#pragma once

#include "correct/calibrated_robot.h"
#include "experiment/paths/cell.h"

namespace handsight {

/// The `count` poses of the calibration (else of the session) that show mount, hand and joint zeros best, of those in
/// which the robot touches nothing as far as there are so many. InputError where neither says where the robot was
/// measured, or where the program has no paths.
std::vector<Eigen::VectorXd> recheck_poses(const CalibratedRobot& before, const Session& session, const Cell& cell,
                                           int count);

}  // namespace handsight
