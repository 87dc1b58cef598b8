// SPDX-License-Identifier: Apache-2.0
#include "estimation/solvers/inverse_parts.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace handsight {

Eigen::VectorXd inverse_scale(const Eigen::MatrixXd& symmetric) {
  // What a plate's turn about its own normal does to a touch is rounding, which no scale may blow up.
  constexpr double rounding = 1e-27;
  const double least = rounding * std::max(symmetric.size() ? symmetric.diagonal().maxCoeff() : 0.0, 0.0);
  return symmetric.diagonal().unaryExpr([&](double d) { return d > least ? 1 / std::sqrt(d) : 0.0; });
}

InverseParts inverse_parts(const Eigen::MatrixXd& symmetric) {
  const Eigen::VectorXd scale = inverse_scale(symmetric);
  const Eigen::MatrixXd scaled = scale.asDiagonal() * symmetric * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scaled);
  const Eigen::VectorXd& values = eigen.eigenvalues();
  const double threshold = 1e-12 * std::max(values.size() ? values.maxCoeff() : 0.0, 0.0);
  InverseParts parts{scale.asDiagonal() * eigen.eigenvectors(),
                     values.unaryExpr([&](double v) { return v > threshold ? 1 / v : 0.0; })};
  for (Eigen::Index i = 0; i < values.size(); ++i) parts.left_out += values[i] > threshold ? 0 : 1;
  for (Eigen::Index i = 0; i < scale.size(); ++i) parts.left_out -= scale[i] == 0 ? 1 : 0;  // not part of the problem
  return parts;
}

Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& symmetric, int* left_out) {
  const InverseParts parts = inverse_parts(symmetric);
  if (left_out) *left_out = parts.left_out;
  return parts.half * parts.inverse.asDiagonal() * parts.half.transpose();
}

}  // namespace handsight
