// SPDX-License-Identifier: Apache-2.0
// How far cameras see the hand from where it is predicted, of one observation.
#pragma once

#include <optional>

#include "estimation/problem/problem.h"

namespace handsight {

/// ErrorSummary::hand_m (fit_report.h) of one observation.
struct HandResidual {
  double size_m = 0;
  Matrix3 unit_covariance = Matrix3::Zero();  // of the shift, for noise of 1 px
};

/// Nothing of a tracker's or pose sensor's observation, and where its sightings do not tell where the hand is.
std::optional<HandResidual> hand_residual(const Problem& images, const ProblemObservation& observation,
                                          const Unknowns& unknowns);

}  // namespace handsight
