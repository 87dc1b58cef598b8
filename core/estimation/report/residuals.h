// SPDX-License-Identifier: Apache-2.0
// What a fit leaves of one observation, and errors summed up from it.
#pragma once

#include <vector>

#include "estimation/report/error_summary.h"
#include "estimation/report/hand_residual.h"

namespace handsight {

/// Residuals of one observation: squares of its coordinates, lengths of its markers' 3D residuals.
struct Residuals {
  double squares = 0;
  int rows = 0;
  std::vector<double> lengths;
  double length_squares_of_noise = 0;  // expected sum of their squares, m^2 per unit of noise squared
  std::optional<HandResidual> hand;
};

/// `images` must stand at the effects of `unknowns`.
Residuals compute_residuals(const Problem& images, const ProblemObservation& observation, const Unknowns& unknowns);

/// Root mean square.
double rms(const std::vector<double>& values);

/// `pixels`: coordinates are of images.
ErrorSummary summary(const std::vector<Residuals>& all, bool pixels);

}  // namespace handsight
