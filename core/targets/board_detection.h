// SPDX-License-Identifier: Apache-2.0
// Parts of detect_target, for targets of which points tell each other their numbers.
#pragma once

#include <optional>
#include <utility>

#include "targets/found_target.h"
#include "vision/image/image.h"

namespace handsight {

/// Why tags that were read are none of the target.
Message lies_otherwise();

/// ChArUco boards and grids: tags that agree on where the board is, then every corner where it should be.
TargetSighting detect_board(const Image& image, const PreparedTarget& target);

/// Chessboards: X-corners that form the whole lattice.
TargetSighting detect_chessboard(const Image& image, const PreparedTarget& target);

/// Columns and rows of the largest whole lattice of X-corners that the image shows; nothing where there is none of 6.
std::optional<std::pair<int, int>> chessboard_size(const Image& image);

}  // namespace handsight
