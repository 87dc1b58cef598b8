// SPDX-License-Identifier: Apache-2.0
// One image of a pyramid, and what was found in it so far.
#pragma once

#include <vector>

#include "vision/corners/corner_board.h"
#include "vision/corners/corner_candidates.h"
#include "vision/corners/corner_look.h"
#include "vision/corners/corner_shadow_lines.h"

namespace handsight {

/// One image, and what was found in it.
struct Level {
  CornerSight sight;
  std::vector<CornerCandidate> candidates;
  std::vector<Found> found;
  std::vector<PredictedCorner> missing;  // what boards predicted in vain
  ShadowLines shadows;                   // by those found beside their edges
};

}  // namespace handsight
