// SPDX-License-Identifier: Apache-2.0
// The corners of one image of a pyramid.
#pragma once

#include <vector>

#include "vision/corners/corner_level_finds.h"

namespace handsight {

/// All corners of the whole image; `half`: becomes the image at half the resolution.
void find_corners(Level& level, Image& half);

/// Of a coarser image what is too blurred for the finer one, and what was missing there. `known`: corners that are
/// known already, and `missing`, both where they lie in the coarser image. `half`, if any: as above.
void find_blurred_corners(const Level& finer, const std::vector<FittedSaddle>& known,
                          const std::vector<PredictedCorner>& missing, Level& level, Image* half);

}  // namespace handsight
