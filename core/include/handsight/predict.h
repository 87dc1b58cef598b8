// SPDX-License-Identifier: Apache-2.0
/// @file
/// Where the hand really is in poses that were not measured, and the files that keep what is needed for it.
#pragma once

#include <filesystem>
#include <vector>

#include "correct/calibrated_robot.h"
#include "handsight/improve.h"

namespace handsight {

/// The robot with what a fit has found. `model` and `options` are those of the fit.
CalibratedRobot calibrated_robot(const Session& session, const Fit& fit, const Model& model,
                                 const FitOptions& options = {});

/// The robot with what an improvement has found; predictions allow for what it leaves open about the effects.
CalibratedRobot calibrated_robot(const Session& session, const Improvement& improvement);

/// Reads a calibration file and the URDF of its robot.
/// Throws InputError where a file cannot be read, does not say what a prediction needs, or does not fit the robot.
CalibratedRobot read_calibrated_robot(const std::filesystem::path& calibration, const std::filesystem::path& urdf);

/// Writes (or replaces) the calibration file, whole or not at all.
/// Throws InputError where it cannot be written, or where a number of it is not finite.
void save_calibration(const std::filesystem::path& file, const CalibratedRobot& robot);

/// Where the hand is for these joint angles (rad, m where a joint is prismatic; in the order of
/// CalibratedRobot::joint_names), at rest. TcpPrediction::root_from_tcp is where the description has it,
/// TcpPrediction::root_from_tcp_est where it is by the model, TcpPrediction::covariance (6 x 6; m, rad; root axes) how
/// sure that is. Where the sensor rides on the hand, the hand is the sensor's link.
/// Throws InputError where the number of angles is not that of the joints, or one is not finite.
TcpPrediction predict(const CalibratedRobot& robot, const Eigen::VectorXd& position);

/// The same for many poses, in their order.
std::vector<TcpPrediction> predict(const CalibratedRobot& robot, const std::vector<Eigen::VectorXd>& positions);

}  // namespace handsight
