// SPDX-License-Identifier: Apache-2.0
// The patch of a fit with its derivatives by all odd unknowns.
#pragma once

#include "vision/corners/corner_odd_unknowns.h"
#include "vision/corners/corner_patch.h"
#include "vision/corners/corner_products.h"
#include "vision/corners/corner_shape.h"

namespace handsight {

constexpr int odd_rows = odd_unknown_count + 1;

/// The odd unknowns' rows in their order, then residuals, as often as a tile reads them.
struct OddRows {
  CornerPatch patch;
  alignas(64) std::array<CornerPatch::Row, 4> more;  // by added light and bends
  int reach = 0;
  Eigen::Vector2i centre{0, 0};
  std::array<const float*, odd_rows + tile_of_rows - 1> rows;
};

/// False where the fit's disc leaves the image.
bool fill_rows(const Image& image, const CornerFit& fit, OddRows& all);

/// Hessian and side of `count` numbers a row.
void set_equations(const float* const* rows, int count, OddSystem& system);

}  // namespace handsight
