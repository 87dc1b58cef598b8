// SPDX-License-Identifier: Apache-2.0
/// @file
/// The joint angles to command so that the hand really arrives where it was meant to be.
#pragma once

#include <optional>

#include "correct/correction.h"
#include "handsight/predict.h"

namespace handsight {

/// Angles (rad, m) near `position` that bring the hand to `root_from_tcp`; without it to where the robot's description
/// has the hand for `position`. Each joint stays within its limits; Correction::reached says whether the hand gets
/// there (to 1e-6 m and rad by the model), Correction::sigma_m how sure its place is then.
/// Throws InputError as predict().
Correction correct(const CalibratedRobot& robot, const Eigen::VectorXd& position,
                   const std::optional<Rigid>& root_from_tcp = std::nullopt);

}  // namespace handsight
