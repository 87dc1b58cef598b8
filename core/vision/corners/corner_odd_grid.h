// SPDX-License-Identifier: Apache-2.0
// Rows of a patch as an image, in which a pixel has neighbours and an opposite.
#pragma once

#include <Eigen/Core>
#include <array>

#include "vision/corners/corner_patch.h"
#include "vision/corners/corner_simd.h"

namespace handsight {

/// With a margin so that neighbours need no care.
constexpr int grid_margin = 3, grid_side = 32, grid_middle = most_patch_radius + 1 + grid_margin;
using OddGrid = std::array<float, grid_side * grid_side + simd_lanes>;

/// The row's first `count` numbers, where their pixels are.
void spread(const CornerPatch::Row& row, int count, OddGrid& grid);

/// Sum over all pixels of a grid times itself, shifted.
float shifted_product(const OddGrid& grid, int reach, const std::array<int, 2>& step);

/// Twice the way (px) from the central pixel to a position, in whole pixels.
Eigen::Vector2i twice_from(const Eigen::Vector2i& centre, const Eigen::Vector2d& position);

/// Half the difference to the point reflected at the corner, which is a half or whole pixel off by `aside` (px): what
/// that makes of the even part is taken away.
OddGrid odd_part(const OddGrid& grid, int reach, const Eigen::Vector2i& twice, const Eigen::Vector2d& aside);

/// By 1 2 1, across and down.
void smooth(OddGrid& grid);

}  // namespace handsight
