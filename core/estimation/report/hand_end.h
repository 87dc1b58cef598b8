// SPDX-License-Identifier: Apache-2.0
// Which end of the measurement chain the robot moves. A sensor on the hand that sees a target beside the robot is the
// same chain the other way round: its TCP link stands still, and the mount's link is the hand. Predictions, corrections
// and programs are about the hand.
#pragma once

#include "estimation/report/prediction.h"

namespace handsight {

/// Does the sensor ride on the hand, before a target that no joint moves?
bool hand_carries_sensor(const Chain& chain);

/// The chain with its ends exchanged: the mount's link as the TCP, the target's as the mount.
Chain chain_of_hand(const Chain& chain);

/// What is known of the hand that carries the sensor, for chain_of_hand: the sensor is the body on the hand, the target
/// what it is seen from. Of the effects those stay that move the robot: what slips or drifts at either end does not
/// move the hand. Nothing where the mount was not estimated.
std::optional<PredictionModel> model_of_hand(const Fit& fit, const ModelUncertainty& model_uncertainty);

/// The same from an exported calibration, for the session's own chain. One without <hand_covariance> tells the mount's
/// sigma and those of the effects alone. Nothing where it does not say where the sensor sits.
std::optional<PredictionModel> model_of_hand(const Calibration& calibration, const Chain& chain);

/// 6 + n: xi of mount_from_sensor (root_from_sensor = root_from_mount exp(xi) mount_from_sensor), then every number of
/// the effects. The mount must be estimated.
Eigen::MatrixXd hand_covariance(const Fit& fit);

/// tcp_repeatability as scatter of the mount's link, in its axes.
TcpRepeatability hand_repeatability(const Fit& fit);

}  // namespace handsight
