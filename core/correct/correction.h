// SPDX-License-Identifier: Apache-2.0
// The joint angles to command so that the hand really arrives where it was meant to be.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "estimation/report/prediction.h"

namespace handsight {

struct Correction {
  Eigen::VectorXd position;                      // to command: rad or m, in the order of the chain, within limits
  double error_before_m = 0, error_after_m = 0;  // of the hand's position by the model: as commanded, and corrected
  double error_before_rad = 0, error_after_rad = 0;
  double sigma_m = 0;    // of the hand's position where it is then: root mean square length that its covariance tells
  bool reached = false;  // to 1e-6 m and 1e-6 rad
  std::vector<int> at_limit;  // of the corrected joints that stand at a limit: places in the position
  int iterations = 0;
};

/// Newton on the model with the derivatives of posture_tangent.h, damped where a step does not come nearer; the
/// shortest way in the joints, each of which stays within its limits. Without `target` (root_from_tcp) the hand is
/// meant to be where the nominal model has it for the commanded joints. `commanded` also says how the robot comes there
/// (approach, velocity, time). What cannot be reached is approached as near as the damped steps lead; a radian counts
/// as 0.3 m then.
Correction corrected(const ObservationState& commanded, const PredictionModel& model,
                     const std::optional<Rigid>& target = std::nullopt);

/// What correcting brings over many poses: the hand's error, m, as it would be measured, one draw of the model's
/// uncertainty each, as commanded and corrected.
struct CorrectionGain {
  std::vector<double> before, after;  // m, one a pose
  double median_before = 0, median_after = 0;
  int not_reached = 0;
};

/// Over `count` poses like the measured ones: each between two of them, drawn; the same for the same seed. Nothing
/// where no pose was measured.
CorrectionGain correction_gain(const Chain& chain, const PredictionModel& model,
                               const std::vector<Eigen::VectorXd>& measured, int count, std::uint64_t seed);

}  // namespace handsight
