// SPDX-License-Identifier: Apache-2.0
// What interpolated colours do to a corner: the odd system that does not see their pattern.
#pragma once

#include <optional>

#include "vision/corners/corner_odd_unknowns.h"
#include "vision/corners/corner_shape.h"
#include "vision/image/image.h"

namespace handsight {

/// The odd system of the patch smoothed by 1 4 6 4 1 across and down: interpolated colours have errors of the pattern's
/// own period, 2 px, which are none any more. The variance is that of noise that changes as slowly as what a position
/// shows in.
std::optional<OddSystem> smoothed_odd_system(const Image& image, const CornerFit& fit);

}  // namespace handsight
