// SPDX-License-Identifier: Apache-2.0
// Corners that a shadow's edge has hidden or drawn aside: each that is found beside it tells the next where it runs.
#pragma once

#include "vision/corners/corner_level_finds.h"

namespace handsight {

/// Looks again at what was taken without knowing of a shadow's edge that runs there, and takes what is missing beside
/// it. Numbers of the lattice begin at `first` with those of this level.
void settle_shadows(Lattice& lattice, const SaddleField& field, int first, Level& level);

}  // namespace handsight
