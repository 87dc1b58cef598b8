// SPDX-License-Identifier: Apache-2.0
// Products of rows of a patch with each other: the normal equations of a fit with many unknowns.
#pragma once

#include <array>

#include "vision/corners/corner_lanes.h"

namespace handsight {

constexpr int kTileOfRows = 4;

/// The lower triangle of the products of `Rows` rows, row by row, each row in whole tiles.
template <int Rows>
using RowProducts = std::array<std::array<float, Rows + kTileOfRows>, Rows>;

// Products of a row with some others, few enough to stay in registers.
template <class Vector>
HANDSIGHT_INLINE void tile_products(const float* row, const float* const* others, int count, float* results) {
  constexpr int kParts = Sum<Vector>::kParts, kStep = kLanesOf<Vector>;
  Sum<Vector> sum[kTileOfRows];
  for (int n = 0; n < count; n += kWideLanes) {
#pragma GCC unroll 2
    for (int p = 0; p < kParts; ++p) {
      Vector a, b;
      load(row + n + p * kStep, a);
#pragma GCC unroll 4
      for (int k = 0; k < kTileOfRows; ++k) load(others[k] + n + p * kStep, b), sum[k].part[p] += a * b;
    }
  }
  Lanes folded[kTileOfRows];
  for (int k = 0; k < kTileOfRows; ++k) fold(sum[k], folded[k]);
  totals(folded, results);
}

// `rows` holds kTileOfRows - 1 more, which are read but not used.
template <class Vector, int Rows>
HANDSIGHT_INLINE void all_products(const float* const* rows, int count, RowProducts<Rows>& products) {
  for (int i = 0; i < Rows; ++i)
    for (int j = 0; j <= i; j += kTileOfRows) tile_products<Vector>(rows[i], rows + j, count, &products[i][j]);
}

}  // namespace handsight
