// SPDX-License-Identifier: Apache-2.0
// A board of each kind.
#pragma once

#include "print/target.h"

namespace handsight::fixture {

inline const Target charuco{
    .kind = TargetKind::charuco, .columns = 8, .rows = 6, .square = 0.03, .tag = 0.022, .dictionary = "DICT_5X5_100"};
inline const Target grid{.kind = TargetKind::aprilgrid,
                         .columns = 6,
                         .rows = 4,
                         .tag = 0.03,
                         .spacing = 0.3,
                         .dictionary = "tag36h11",
                         .border = 2};
inline const Target chessboard{.kind = TargetKind::chessboard, .columns = 9, .rows = 6, .square = 0.025};

}  // namespace handsight::fixture
