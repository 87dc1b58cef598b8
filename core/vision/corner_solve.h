// SPDX-License-Identifier: Apache-2.0
// Normal equations of few unknowns.
#pragma once

#include <Eigen/Core>

namespace handsight {

/// The symmetric matrix of which `triangle` is the lower triangle, row by row.
template <int N>
Eigen::Matrix<double, N, N> from_triangle(const float* triangle) {
  Eigen::Matrix<double, N, N> m;
  for (int i = 0, n = 0; i < N; ++i)
    for (int j = 0; j <= i; ++j) m(i, j) = m(j, i) = triangle[n++];
  return m;
}

/// m x = b by L D L^T, b in `x` at first: for few unknowns Eigen's blocked Cholesky takes several times as long. False
/// where `m` is not positive definite.
template <int N>
bool solve(Eigen::Matrix<double, N, N> m, Eigen::Matrix<double, N, 1>& x) {
  Eigen::Matrix<double, N, 1> inverse;  // of D
  for (int j = 0; j < N; ++j) {
    double row[N];  // L(j, k) D(k)
    for (int k = 0; k < j; ++k) row[k] = m(j, k), m(j, k) *= inverse(k), m(j, j) -= row[k] * m(j, k);
    if (!(m(j, j) > 1e-9)) return false;
    inverse(j) = 1 / m(j, j);
    for (int i = j + 1; i < N; ++i)
      for (int k = 0; k < j; ++k) m(i, j) -= m(i, k) * m(j, k);
  }
  for (int i = 0; i < N; ++i)
    for (int k = 0; k < i; ++k) x(i) -= m(i, k) * x(k);
  x.array() *= inverse.array();
  for (int i = N - 1; i >= 0; --i)
    for (int k = i + 1; k < N; ++k) x(i) -= m(k, i) * x(k);
  return x.allFinite();
}

/// The inverse of a positive definite matrix, unknown by unknown; false where it is none.
template <int N>
bool invert(Eigen::Matrix<double, N, N>& m) {
  for (int k = 0; k < N; ++k) {
    if (!(m(k, k) > 1e-12)) return false;
    const double inverse = 1 / m(k, k);
    const Eigen::Matrix<double, N, 1> column = m.col(k);
    m.noalias() -= column * (inverse * column.transpose());
    m.col(k) = inverse * column, m.row(k) = inverse * column.transpose();
    m(k, k) = -inverse;
  }
  m = -m;
  return m.allFinite();
}

}  // namespace handsight
