// SPDX-License-Identifier: Apache-2.0
// Parts of detect_target, for targets of which points tell each other their numbers.
#pragma once

#include "targets/found_target.h"
#include "vision/image/image.h"

namespace handsight {

/// ChArUco boards and grids: tags that agree on where the board is, then every corner where it should be.
TargetSighting detect_board(const Image& image, const PreparedTarget& target);

/// Chessboards: X-corners that form the whole lattice.
TargetSighting detect_chessboard(const Image& image, const PreparedTarget& target);

}  // namespace handsight
