// SPDX-License-Identifier: Apache-2.0
// Parts of detect_target, one for each way in which points get their numbers.
#pragma once

#include "targets/homography.h"
#include "targets/target_detection.h"

namespace handsight {

/// ChArUco boards and grids: tags that agree on where the board is, then every corner where it should be.
TargetSighting detect_board(const Image& image, const PreparedTarget& target);

/// Chessboards: X-corners that form the whole lattice.
TargetSighting detect_chessboard(const Image& image, const PreparedTarget& target);

/// Single tags.
TargetSighting detect_single_tags(const Image& image, const PreparedTarget& target);

/// A corner of four sectors as the target has it.
struct ExpectedCorner {
  int number = 0;
  Vector2 place = Vector2::Zero();  // m
  double reach = 0;                 // m, within which the four sectors are even
  bool is_black_between = false;    // the sector between +x and +y and the opposite one are black, or the other two
};
ExpectedCorner expected_corner(const PreparedTarget& target, int number);

/// The X-corner refined from where `map` has it, within 3 px, with edges along the plane's x and y and sectors of the
/// right colours. Nothing where there is none; `dropped` counts what was found there but is no such corner.
std::optional<TargetPixel> corner_at(const Image& image, const PlaneMap& map, const ExpectedCorner& expected,
                                     int& dropped);

/// Leaves out, and counts, the points that are farther from where the others have them than their scatter explains.
void drop_far_points(TargetSighting& sighting, const std::vector<TargetPoint>& points, int width, int height);

}  // namespace handsight
