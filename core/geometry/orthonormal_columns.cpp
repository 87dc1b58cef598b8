// SPDX-License-Identifier: Apache-2.0
#include "geometry/orthonormal_columns.h"

#include <Eigen/QR>

namespace handsight {

Eigen::MatrixXd orthonormal_columns(const Eigen::MatrixXd& columns) {
  return Eigen::HouseholderQR<Eigen::MatrixXd>(columns).householderQ() *
         Eigen::MatrixXd::Identity(columns.rows(), columns.cols());
}

}  // namespace handsight
