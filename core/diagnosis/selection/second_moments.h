// SPDX-License-Identifier: Apache-2.0
// How far the numbers of all models that may be are from those of the one that was chosen.
#pragma once

#include <Eigen/Core>

#include "diagnosis/selection/model_posterior.h"

namespace handsight {

/// Second moments of the open numbers (prior sigmas; n x n, in the order of `score`) about those of `model`, a choice
/// of open units, beside the covariance that the model's own numbers have.
Eigen::MatrixXd second_moments(const ModelSpace& all, const OpenUnits& units, const OpenScore& score,
                               const Weights& weights, const Chosen& model);

}  // namespace handsight
