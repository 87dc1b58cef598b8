// SPDX-License-Identifier: Apache-2.0
#include "estimation/solvers/unit_factor.h"

#include "estimation/solvers/covariance_factor.h"

namespace handsight {

Eigen::MatrixXd unit_factor(const Solution& s) {
  return s.basis * pseudo_inverse_factor(s.basis.transpose() * s.normal.information * s.basis);
}

}  // namespace handsight
