// SPDX-License-Identifier: Apache-2.0
// Which marker is which, by the sides between them: whoever points at them need not know the order.
#pragma once

#include <optional>
#include <vector>

#include "geometry/rigid.h"
#include "vision/markers/known_markers.h"

namespace handsight {

/// A marker as it was pointed at: the number it was given, and where it is (m, the sensor's frame).
struct NumberedPoint {
  int marker = 0;
  Vector3 point{0, 0, 0};
  Matrix3 covariance = Matrix3::Identity();  // m^2
};

/// The numbers that the points have among the known markers, where those that they were given cannot be right: as they
/// are numbered the sides differ from the known ones by more than four sigma, in one other order they agree, and no
/// further order does. In the order of `points`. Nothing where the numbers may stay, where nothing fits, where two
/// orders fit (equal sides), or with fewer than three points whose markers are known.
std::optional<std::vector<int>> numbers_by_sides(const std::vector<NumberedPoint>& points, const KnownMarkers& known);

}  // namespace handsight
