// SPDX-License-Identifier: Apache-2.0
// How sure a bundle is of the cameras, everything else taken out.
#pragma once

#include <ceres/ceres.h>

#include "camera_calibration/bundle_costs.h"

namespace handsight {

/// The unknowns of a bundle and what Ceres knows of them.
struct BundleProblem {
  std::vector<std::vector<double>> lenses;
  std::vector<Six> placements, poses;
  std::array<double, 3> bend{};
  std::vector<std::array<double, 3>> points;  // by number; empty unless each is estimated
  std::vector<Vector3> weights;               // of place_cost, by number
  ceres::Problem solver;
  std::vector<int> frames;  // with a pose, ascending
};

/// Fills in the covariances of a result whose residuals are known; they stay empty where the images do not determine
/// the numbers.
void set_covariances(BundleResult& result, BundleProblem& problem);

}  // namespace handsight
