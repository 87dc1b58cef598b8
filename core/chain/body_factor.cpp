// SPDX-License-Identifier: Apache-2.0
#include "chain/body_factor.h"

#include <cmath>

#include "chain/unknown_angle.h"

namespace handsight {

Eigen::MatrixXd body_factor(const BodyFrame& frame, const Eigen::MatrixXd& marker_factor) {
  Eigen::MatrixXd factor(6, marker_factor.cols() + frame.unobserved.cols());
  factor << frame.motion_by_markers * marker_factor, std::sqrt(unknown_angle_variance) * frame.unobserved;
  return factor;
}

}  // namespace handsight
