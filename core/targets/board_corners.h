// SPDX-License-Identifier: Apache-2.0
// X-corners where a board should have them, and which of all points to leave out.
#pragma once

#include <optional>
#include <vector>

#include "targets/found_target.h"
#include "targets/homography.h"
#include "vision/image/image.h"

namespace handsight {

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

/// The same where `pixel` is expected and the image moves with the place by `slope` (px by m).
std::optional<TargetPixel> corner_at(const Image& image, const Vector2& pixel, const Eigen::Matrix2d& slope,
                                     const ExpectedCorner& expected, int& dropped);

/// Leaves out, and counts, the points that are farther from where the others have them than their scatter explains.
void drop_far_points(TargetSighting& sighting, const std::vector<TargetPoint>& points, int width, int height);

}  // namespace handsight
