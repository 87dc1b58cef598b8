// SPDX-License-Identifier: Apache-2.0
// Normal equations of few unknowns.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <utility>

#include "vision/corners/corner_simd.h"

namespace handsight {

/// The symmetric matrix of which `triangle` is the lower triangle, row by row.
template <int N>
Eigen::Matrix<double, N, N> from_triangle(const float* triangle) {
  Eigen::Matrix<double, N, N> m;
  for (int i = 0, n = 0; i < N; ++i)
    for (int j = 0; j <= i; ++j) m(i, j) = m(j, i) = triangle[n++];
  return m;
}

/// Calls act for 0 to N - 1, each known to the compiler.
template <int N, class Act>
HANDSIGHT_INLINE void each_number(const Act& act) {
  [&]<int... numbers>(std::integer_sequence<int, numbers...>) { (act(std::integral_constant<int, numbers>()), ...); }
  (std::make_integer_sequence<int, N>());
}

/// m x = b by L D L^T, b in `x` at first: for few unknowns Eigen's blocked Cholesky takes several times as long. False
/// where `m` is not positive definite.
template <int N>
bool solve(Eigen::Matrix<double, N, N> m, Eigen::Matrix<double, N, 1>& x) {
  Eigen::Matrix<double, N, 1> inverse;  // of D
  bool is_positive = true;
  each_number<N>([&](auto number) {
    constexpr int j = number;
    is_positive &= m(j, j) > 1e-9;
    inverse(j) = 1 / m(j, j);
    const double step = x(j) * inverse(j);
    for (int i = j + 1; i < N; ++i) x(i) -= m(i, j) * step;
    for (int k = j + 1; k < N; ++k) {  // what is left of the columns, each from its diagonal on
      const double factor = m(k, j) * inverse(j);
      for (int i = k; i < N; ++i) m(i, k) -= m(i, j) * factor;
    }
  });
  each_number<N>([&](auto number) {
    constexpr int j = N - 1 - number;
    for (int i = j + 1; i < N; ++i) x(j) -= m(i, j) * x(i);
    x(j) *= inverse(j);
  });
  return is_positive && x.allFinite();
}

/// The inverse of a positive definite matrix, unknown by unknown; false where it is none.
template <int N>
HANDSIGHT_INLINE bool invert(Eigen::Matrix<double, N, N>& matrix) {
  double* const m = matrix.data();
  double column[N], share[N], sum = 0;
  for (int k = 0; k < N; ++k) {
    if (!(m[k * N + k] > 1e-12)) return false;
    const double inverse = 1 / m[k * N + k];
    for (int i = 0; i < N; ++i) column[i] = m[k * N + i], share[i] = inverse * column[i];
    for (int j = 0; j < N; ++j)
      for (int i = 0; i < N; ++i) m[j * N + i] -= column[i] * share[j];
    for (int i = 0; i < N; ++i) m[k * N + i] = m[i * N + k] = share[i];
    m[k * N + k] = -inverse;
  }
  for (int i = 0; i < N * N; ++i) m[i] = -m[i], sum += m[i];
  return std::isfinite(sum);
}

}  // namespace handsight
