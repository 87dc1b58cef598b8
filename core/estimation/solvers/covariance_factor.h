// SPDX-License-Identifier: Apache-2.0
// Covariances as factors: what is propagated is f with f f^T, so that no rounding makes a variance negative or a
// correlation more than 1, however little some direction is known.
#pragma once

#include <Eigen/Core>

namespace handsight {

/// f f^T: symmetric bit by bit. Each number's rounding is that of its own sigma, not of the largest one.
Eigen::MatrixXd covariance_from(const Eigen::MatrixXd& factor);

/// A factor (n x n) of the nearest covariance, as correlations: where a sum of moments is all there is, rounding may
/// have left it a little negative in some direction. NaN where a number is not finite.
Eigen::MatrixXd make_factor(const Eigen::MatrixXd& symmetric);

/// A factor (n x n) of the pseudo-inverse.
Eigen::MatrixXd pseudo_inverse_factor(const Eigen::MatrixXd& symmetric);

/// A factor of the covariance h m h^T, h = u u^T with u = `unit`, m = `middle` the second moment of the score (J^T W
/// Sigma W J): u is as long in a direction as it is unknown, and u^T m u is about 1 in each. h m h itself would lose as
/// many digits in rounding as the square of that length has.
Eigen::MatrixXd sandwich_factor(const Eigen::MatrixXd& unit, const Eigen::MatrixXd& middle);

}  // namespace handsight
