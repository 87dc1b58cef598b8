// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace handsight {

/// As many orthonormal columns as `columns` has, which span what those span where they are independent (Householder's
/// QR); m x n, n <= m.
Eigen::MatrixXd orthonormal_columns(const Eigen::MatrixXd& columns);

}  // namespace handsight
