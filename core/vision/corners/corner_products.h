// SPDX-License-Identifier: Apache-2.0
// Products of rows of a patch with each other: the normal equations of a fit with many unknowns.
#pragma once

#include <array>

#include "vision/corners/corner_simd.h"

namespace handsight {

constexpr int tile_of_rows = 4;

/// The lower triangle of the products of `Rows` rows, row by row, each row in whole tiles.
template <int Rows>
using RowProducts = std::array<std::array<float, Rows + tile_of_rows>, Rows>;

// Products of a row with some others, few enough to stay in registers.
template <class Vector>
HANDSIGHT_INLINE void tile_products(const float* row, const float* const* others, int count, float* results) {
  constexpr int part_count = Sum<Vector>::part_count, step_size = lanes_of_simd<Vector>;
  Sum<Vector> sum[tile_of_rows];
  for (int n = 0; n < count; n += wide_simd_lanes) {
#pragma GCC unroll 2
    for (int p = 0; p < part_count; ++p) {
      Vector a, b;
      load(row + n + p * step_size, a);
#pragma GCC unroll 4
      for (int k = 0; k < tile_of_rows; ++k) load(others[k] + n + p * step_size, b), sum[k].part[p] += a * b;
    }
  }
  Simd folded[tile_of_rows];
  for (int k = 0; k < tile_of_rows; ++k) fold(sum[k], folded[k]);
  totals(folded, results);
}

// `rows` holds tile_of_rows - 1 more, which are read but not used.
template <class Vector, int Rows>
HANDSIGHT_INLINE void all_products(const float* const* rows, int count, RowProducts<Rows>& products) {
  for (int i = 0; i < Rows; ++i)
    for (int j = 0; j <= i; j += tile_of_rows) tile_products<Vector>(rows[i], rows + j, count, &products[i][j]);
}

}  // namespace handsight
