// SPDX-License-Identifier: Apache-2.0
// The sums over a patch of corner_patch.h, each in lanes and in wide lanes; the processor decides.
#include <algorithm>
#include <array>

#include "vision/corners/corner_lanes.h"
#include "vision/corners/corner_patch.h"

namespace handsight {
namespace {

// Products of the last row with all and with the residual: few enough sums to stay in registers.
template <class Vector, int Rows>
HANDSIGHT_INLINE void row_products(const CornerPatch::Row* rows, const CornerPatch::Row& residual, int count,
                                   Lanes* triangle, Lanes* side) {
  constexpr int kParts = Sum<Vector>::kParts, kStep = kLanesOf<Vector>;
  Sum<Vector> sum[Rows], sides;
  for (int n = 0; n < count; n += kWideLanes) {
#pragma GCC unroll 2
    for (int p = 0; p < kParts; ++p) {
      Vector last, a;
      load(&rows[Rows - 1][n + p * kStep], last);
#pragma GCC unroll 8
      for (int i = 0; i < Rows; ++i) load(&rows[i][n + p * kStep], a), sum[i].part[p] += last * a;
      load(&residual[n + p * kStep], a);
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
                                       Lanes* sums) {
  constexpr int kTriangle = Rows * (Rows + 1) / 2;
  row_products<Vector, 1>(rows, residual, count, sums, sums + kTriangle);
  row_products<Vector, 2>(rows, residual, count, sums, sums + kTriangle);
  row_products<Vector, 3>(rows, residual, count, sums, sums + kTriangle);
  row_products<Vector, 4>(rows, residual, count, sums, sums + kTriangle);
  if constexpr (Rows == 5) row_products<Vector, 5>(rows, residual, count, sums, sums + kTriangle);
}

constexpr int kOddSums = 10 + 4, kEvenSums = 15 + 5 + 1, kSums = 24;

template <class Vector>
HANDSIGHT_INLINE void add_up_odd(const CornerPatch& patch, float* results) {
  Lanes sums[kSums]{};
  all_row_products<Vector, 4>(patch.odd.data(), patch.residual, patch.padded, sums);
  for (int i = 0; i < kOddSums; i += 4) totals(sums + i, results + i);
}

template <class Vector>
HANDSIGHT_INLINE void add_up_even(const CornerPatch& patch, float* results) {
  Lanes sums[kSums]{};
  all_row_products<Vector, 5>(patch.even.data(), patch.residual, patch.padded, sums);
  row_products<Vector, 1>(&patch.residual, patch.residual, patch.padded, sums + kEvenSums - 1, sums + kEvenSums);
  for (int i = 0; i < kEvenSums; i += 4) totals(sums + i, results + i);
}

HANDSIGHT_LANES void odd_in_lanes(const CornerPatch& patch, float* results) { add_up_odd<Lanes>(patch, results); }
HANDSIGHT_WIDE void odd_in_wide(const CornerPatch& patch, float* results) { add_up_odd<WideLanes>(patch, results); }
HANDSIGHT_LANES void even_in_lanes(const CornerPatch& patch, float* results) { add_up_even<Lanes>(patch, results); }
HANDSIGHT_WIDE void even_in_wide(const CornerPatch& patch, float* results) { add_up_even<WideLanes>(patch, results); }

}  // namespace

PatchSums sums(const CornerPatch& patch) {
  PatchSums result;
  std::array<float, kSums> odd, even;
  (has_wide_lanes() ? odd_in_wide : odd_in_lanes)(patch, odd.data());
  (has_wide_lanes() ? even_in_wide : even_in_lanes)(patch, even.data());
  std::copy_n(odd.begin(), 10, result.odd.begin()), std::copy_n(odd.begin() + 10, 4, result.odd_side.begin());
  std::copy_n(even.begin(), 15, result.even.begin()), std::copy_n(even.begin() + 15, 5, result.even_side.begin());
  result.squares = even[20];
  result.weights = result.even[9];  // level with level
  return result;
}

HANDSIGHT_LANES float squared_weights(const CornerPatch& patch) {
  constexpr Lanes kNumber{0, 1, 2, 3, 4, 5, 6, 7};
  Lanes sum{}, weight, zero{};
  for (int n = 0; n < patch.padded; n += kLanes) {
    load(&patch.weight[n], weight);
    weight = kNumber < static_cast<float>(patch.count - n) ? weight : zero;
    sum += weight * weight;
  }
  return total(sum);
}

std::array<float, 10> odd_sums(const CornerPatch& patch) {
  std::array<float, kSums> sums;
  (has_wide_lanes() ? odd_in_wide : odd_in_lanes)(patch, sums.data());
  std::array<float, 10> odd;
  std::copy_n(sums.begin(), 10, odd.begin());
  return odd;
}

}  // namespace handsight
