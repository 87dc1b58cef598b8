// SPDX-License-Identifier: Apache-2.0
// The covariance of the body frame as a factor.
#pragma once

#include "chain/body_frame.h"

namespace handsight {

/// A factor of body_covariance, 6 x (k + columns of `unobserved`), from a factor of the markers' covariance (3m x k).
Eigen::MatrixXd body_factor(const BodyFrame& frame, const Eigen::MatrixXd& marker_factor);

}  // namespace handsight
