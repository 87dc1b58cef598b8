// SPDX-License-Identifier: Apache-2.0
#include "estimation/solvers/covariance_factor.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>

#include "estimation/problem/column_products.h"
#include "estimation/solvers/inverse_parts.h"

namespace handsight {

Eigen::MatrixXd covariance_from(const Eigen::MatrixXd& factor) { return column_products(factor.transpose().eval()); }

Eigen::MatrixXd make_factor(const Eigen::MatrixXd& symmetric) {
  if (!symmetric.allFinite())
    return Eigen::MatrixXd::Constant(symmetric.rows(), symmetric.cols(), std::numeric_limits<double>::quiet_NaN());
  const Eigen::VectorXd sigma = symmetric.diagonal().cwiseMax(0).cwiseSqrt();
  const Eigen::VectorXd inverse = sigma.unaryExpr([](double s) { return s > 0 ? 1 / s : 0.0; });
  const Eigen::MatrixXd correlation = inverse.asDiagonal() * symmetric * inverse.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(correlation);
  return sigma.asDiagonal() * eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal();
}

Eigen::MatrixXd pseudo_inverse_factor(const Eigen::MatrixXd& symmetric) {
  const InverseParts parts = inverse_parts(symmetric);
  return parts.half * parts.inverse.cwiseSqrt().asDiagonal();
}

Eigen::MatrixXd sandwich_factor(const Eigen::MatrixXd& unit, const Eigen::MatrixXd& middle) {
  return unit * make_factor(unit.transpose() * middle * unit);
}

}  // namespace handsight
