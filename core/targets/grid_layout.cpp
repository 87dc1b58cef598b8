// SPDX-License-Identifier: Apache-2.0
#include "targets/grid_layout.h"

#include <array>
#include <map>
#include <vector>

#include "targets/homography.h"

namespace handsight {
namespace {

using Corners = std::array<Vector2, 4>;  // px

std::map<int, Corners> corners_by_tag(const TargetSighting& sighting) {
  std::map<int, Corners> corners;
  for (const auto& point : sighting.points)
    corners[point.number / 4][static_cast<std::size_t>(point.number % 4)] = point.pixel;
  return corners;
}

Vector2 middle(const Corners& c) { return 0.25 * (c[0] + c[1] + c[2] + c[3]); }

/// m, on the sheet.
Vector2 place_of(const PreparedTarget& target, int tag, int corner) {
  return target.points[static_cast<std::size_t>(4 * tag + corner)].position.head<2>();
}

Vector2 place_of(const PreparedTarget& target, int tag) {
  return 0.5 * (place_of(target, tag, 0) + place_of(target, tag, 2));
}

/// Is `other` where the plane of `tag` has it?
bool is_where_expected(const PreparedTarget& target, int tag, const Corners& seen, int other, const Corners& there) {
  std::vector<PlacePixel> points;
  for (int i = 0; i < 4; ++i) points.push_back({place_of(target, tag, i), seen[static_cast<std::size_t>(i)]});
  const auto plane = linear_homography(points);
  if (!plane) return true;
  const Vector3 expected = *plane * place_of(target, other).homogeneous();
  if (expected.z() <= 0) return true;
  const double half_side = 0.25 * ((there[0] - there[2]).norm() + (there[1] - there[3]).norm());
  return (expected.hnormalized() - middle(there)).norm() < half_side;
}

}  // namespace

bool lies_as_described(const TargetSighting& sighting, const PreparedTarget& target) {
  const Target& t = target.target;
  if (!is_tag_grid(t)) return true;
  const std::map<int, Corners> corners = corners_by_tag(sighting);
  const double next = 1.01 * (t.tag + t.separation);
  int asked = 0, right = 0;
  for (const auto& [tag, seen] : corners)
    for (const auto& [other, there] : corners) {
      if (tag == other || (place_of(target, tag) - place_of(target, other)).norm() > next) continue;
      ++asked;
      right += is_where_expected(target, tag, seen, other, there);
    }
  constexpr int least = 6;  // three pairs, from either side
  return asked < least || 2 * right > asked;
}

}  // namespace handsight
