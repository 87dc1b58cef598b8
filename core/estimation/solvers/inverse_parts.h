// SPDX-License-Identifier: Apache-2.0
// Symmetric matrices inverted by their eigenvectors, after the diagonal is scaled to 1.
#pragma once

#include <Eigen/Core>

namespace handsight {

/// half diag(inverse) half^T is the pseudo-inverse.
struct InverseParts {
  Eigen::MatrixXd half;
  Eigen::VectorXd inverse;  // 0 in directions that are left out: an eigenvalue below 1e-12 of the largest
  int left_out = 0;         // of these, what the matrix has a diagonal for
};

InverseParts inverse_parts(const Eigen::MatrixXd& symmetric);

/// Symmetric pseudo-inverse after scaling the diagonal to 1; directions with an eigenvalue below 1e-12 of the largest
/// are left out and counted.
Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& symmetric, int* left_out = nullptr);

/// What scales the diagonal to 1; 0 where it is not positive.
Eigen::VectorXd inverse_scale(const Eigen::MatrixXd& symmetric);

}  // namespace handsight
