// SPDX-License-Identifier: Apache-2.0
// The sums over a patch of corner_patch.h, each in lanes and in wide lanes; the processor decides.
#include <algorithm>
#include <array>

#include "vision/corners/corner_patch.h"
#include "vision/corners/corner_simd.h"

namespace handsight {
namespace {

// Products of the last row with all and with the residual: few enough sums to stay in registers.
template <class Vector, int Rows>
HANDSIGHT_INLINE void row_products(const CornerPatch::Row* rows, const CornerPatch::Row& residual, int count,
                                   Simd* triangle, Simd* side) {
  constexpr int part_count = Sum<Vector>::part_count, step_size = lanes_of_simd<Vector>;
  Sum<Vector> sum[Rows], sides;
  for (int n = 0; n < count; n += wide_simd_lanes) {
#pragma GCC unroll 2
    for (int p = 0; p < part_count; ++p) {
      Vector last, a;
      load(&rows[Rows - 1][n + p * step_size], last);
#pragma GCC unroll 8
      for (int i = 0; i < Rows; ++i) load(&rows[i][n + p * step_size], a), sum[i].part[p] += last * a;
      load(&residual[n + p * step_size], a);
      sides.part[p] += last * a;
    }
  }
#pragma GCC unroll 8
  for (int i = 0; i < Rows; ++i) fold(sum[i], triangle[Rows * (Rows - 1) / 2 + i]);
  fold(sides, side[Rows - 1]);
}

// All of the triangle, row by row, then those with the residual.
template <class Vector, int Rows>
HANDSIGHT_INLINE void all_row_products(const CornerPatch::Row* rows, const CornerPatch::Row& residual, int count,
                                       Simd* sums) {
  constexpr int triangle_size = Rows * (Rows + 1) / 2;
  row_products<Vector, 1>(rows, residual, count, sums, sums + triangle_size);
  row_products<Vector, 2>(rows, residual, count, sums, sums + triangle_size);
  row_products<Vector, 3>(rows, residual, count, sums, sums + triangle_size);
  row_products<Vector, 4>(rows, residual, count, sums, sums + triangle_size);
  if constexpr (Rows == 5) row_products<Vector, 5>(rows, residual, count, sums, sums + triangle_size);
}

constexpr int odd_sum_count = 10 + 4, even_sums = 15 + 5 + 1, sum_count = 24;

template <class Vector>
HANDSIGHT_INLINE void add_up_odd(const CornerPatch& patch, float* results) {
  Simd sums[sum_count]{};
  all_row_products<Vector, 4>(patch.odd.data(), patch.residual, patch.padded, sums);
  for (int i = 0; i < odd_sum_count; i += 4) totals(sums + i, results + i);
}

template <class Vector>
HANDSIGHT_INLINE void add_up_even(const CornerPatch& patch, float* results) {
  Simd sums[sum_count]{};
  all_row_products<Vector, 5>(patch.even.data(), patch.residual, patch.padded, sums);
  row_products<Vector, 1>(&patch.residual, patch.residual, patch.padded, sums + even_sums - 1, sums + even_sums);
  for (int i = 0; i < even_sums; i += 4) totals(sums + i, results + i);
}

HANDSIGHT_LANES void odd_simd(const CornerPatch& patch, float* results) { add_up_odd<Simd>(patch, results); }
HANDSIGHT_WIDE void odd_in_wide(const CornerPatch& patch, float* results) { add_up_odd<WideSimd>(patch, results); }
HANDSIGHT_LANES void even_simd(const CornerPatch& patch, float* results) { add_up_even<Simd>(patch, results); }
HANDSIGHT_WIDE void even_in_wide(const CornerPatch& patch, float* results) { add_up_even<WideSimd>(patch, results); }

}  // namespace

PatchSums sums(const CornerPatch& patch) {
  PatchSums result;
  std::array<float, sum_count> odd, even;
  (has_wide_simd() ? odd_in_wide : odd_simd)(patch, odd.data());
  (has_wide_simd() ? even_in_wide : even_simd)(patch, even.data());
  std::copy_n(odd.begin(), 10, result.odd.begin()), std::copy_n(odd.begin() + 10, 4, result.odd_side.begin());
  std::copy_n(even.begin(), 15, result.even.begin()), std::copy_n(even.begin() + 15, 5, result.even_side.begin());
  result.squares = even[20];
  result.weights = result.even[9];  // level with level
  return result;
}

HANDSIGHT_LANES float squared_weights(const CornerPatch& patch) {
  constexpr Simd lane_numbers{0, 1, 2, 3, 4, 5, 6, 7};
  Simd sum{}, weight, zero{};
  for (int n = 0; n < patch.padded; n += simd_lanes) {
    load(&patch.weight[n], weight);
    weight = lane_numbers < static_cast<float>(patch.count - n) ? weight : zero;
    sum += weight * weight;
  }
  return total(sum);
}

std::array<float, 10> odd_sums(const CornerPatch& patch) {
  std::array<float, sum_count> sums;
  (has_wide_simd() ? odd_in_wide : odd_simd)(patch, sums.data());
  std::array<float, 10> odd;
  std::copy_n(sums.begin(), 10, odd.begin());
  return odd;
}

}  // namespace handsight
