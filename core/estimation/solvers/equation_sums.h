// SPDX-License-Identifier: Apache-2.0
// What the normal equations of a problem hold.
#pragma once

#include <Eigen/Core>

namespace handsight {

/// H = J^T W J, gradient = J^T W error by the problem's columns; cost = error^T W error. The priors of the effects are
/// part of all three, in units of the noise: (noise value / sigma)^2, and so is what images of a board say of the
/// cameras; `prior_cost` is their share.
struct NormalEquations {
  Eigen::MatrixXd information;
  Eigen::VectorXd gradient;
  double cost = 0;
  double prior_cost = 0;
  int rows = 0;
  bool in_front = true;

  explicit NormalEquations(Eigen::Index columns = 0)
      : information(Eigen::MatrixXd::Zero(columns, columns)), gradient(Eigen::VectorXd::Zero(columns)) {}
  double data_cost() const { return cost - prior_cost; }
};

}  // namespace handsight
