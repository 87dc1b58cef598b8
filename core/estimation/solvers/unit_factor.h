// SPDX-License-Identifier: Apache-2.0
// The unit covariance of a solution as a factor.
#pragma once

#include "estimation/solvers/least_squares.h"

namespace handsight {

/// A factor of unit_covariance: the problem's columns x unknowns; what cannot be observed is zero.
Eigen::MatrixXd unit_factor(const Solution& solution);

}  // namespace handsight
