// SPDX-License-Identifier: Apache-2.0
#include "camera_calibration/bent_board.h"

#include <array>

namespace handsight {

Vector3 find_middle(const std::vector<Vector3>& points) {
  Vector3 middle = Vector3::Zero();
  for (const Vector3& point : points) middle += point / static_cast<double>(points.size());
  return middle;
}

Vector3 bent_point(const Vector3& described, const Vector3& middle, const Vector3& bend, Matrix3* by_bend) {
  const Vector2 x = (described - middle).head<2>();
  Eigen::Matrix2d curvature;
  curvature << bend.x(), bend.z(), bend.z(), bend.y();
  const Vector2 slope = curvature * x;
  const double rise = x.dot(slope);
  Vector3 point = described;
  // A bow of curvature k over the length s is s - k^2 s^3 / 6 wide: along the direction of the bend, and only there.
  point.head<2>() -= slope * rise / 6;
  point.z() += 0.5 * rise;
  if (!by_bend) return point;
  const std::array<Vector2, 3> slopes{Vector2(x.x(), 0), Vector2(0, x.y()), Vector2(x.y(), x.x())};
  for (int k = 0; k < 3; ++k) {
    const Vector2& by_one = slopes[static_cast<std::size_t>(k)];
    by_bend->col(k) << -(by_one * rise + slope * x.dot(by_one)) / 6, 0.5 * x.dot(by_one);
  }
  return point;
}

}  // namespace handsight
