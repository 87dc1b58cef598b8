// SPDX-License-Identifier: Apache-2.0
#include "targets/board_corners.h"

#include <algorithm>
#include <cmath>

#include "base/median.h"
#include "targets/sampling.h"
#include "vision/corners/corner_detector.h"

namespace handsight {
namespace {

constexpr double most_askew = 0.2;  // rad, between an edge and where the plane has it

/// Do two lines have the directions of the plane's axes, in any order?
bool runs_along(const std::array<double, 2>& edges, const Eigen::Matrix2d& slope) {
  const auto apart = [](double a, double b) { return std::abs(std::remainder(a - b, M_PI)); };
  const double x = std::atan2(slope(1, 0), slope(0, 0)), y = std::atan2(slope(1, 1), slope(0, 1));
  return std::min(std::max(apart(edges[0], x), apart(edges[1], y)), std::max(apart(edges[1], x), apart(edges[0], y))) <
         most_askew;
}

/// Two opposite sectors darker than the other two?
bool has_sectors(const Image& image, const Vector2& pixel, const Eigen::Matrix2d& slope, const ExpectedCorner& corner) {
  const double reach =
      0.6 * corner.reach * (corner.is_black_between ? 1 : -1);  // mirrored: the dark ones lie along x = y
  const auto grey = [&](double x, double y) {
    return grey_at(image, pixel + slope * Vector2(x * std::abs(reach), y * reach));
  };
  return std::max(grey(1, 1), grey(-1, -1)) < std::min(grey(1, -1), grey(-1, 1));
}

}  // namespace

ExpectedCorner expected_corner(const PreparedTarget& target, int number) {
  const Target& t = target.target;
  ExpectedCorner corner{number, target.points[static_cast<std::size_t>(number)].position.head<2>()};
  if (t.kind == TargetKind::aprilgrid) {
    const int modules = find_dictionary(t.dictionary)->bits + 2 * t.border;
    corner.reach = t.tag * std::min(t.spacing, static_cast<double>(t.border) / modules);
    corner.is_black_between = number % 2 == 0;  // the tag and the square across its corner
    return corner;
  }
  const bool is_charuco = t.kind == TargetKind::charuco;
  const int columns = is_charuco ? t.columns - 1 : t.columns;
  const bool begins_white = is_charuco && t.old_layout && t.rows % 2 == 0;
  corner.reach = is_charuco ? 0.5 * (t.square - t.tag) : 0.4 * t.square;
  corner.is_black_between = ((number / columns + number % columns) % 2 == 0) != begins_white;
  return corner;
}

std::optional<TargetPixel> corner_at(const Image& image, const PlaneMap& map, const ExpectedCorner& corner,
                                     int& dropped) {
  const auto expected = mapped(map, corner.place);
  const auto slope = mapped_slope(map, corner.place, 0.5 * corner.reach);
  if (!expected || !slope) return std::nullopt;
  return corner_at(image, *expected, *slope, corner, dropped);
}

std::optional<TargetPixel> corner_at(const Image& image, const Vector2& pixel, const Eigen::Matrix2d& slope,
                                     const ExpectedCorner& corner, int& dropped) {
  if (!is_inside(image, pixel, 4)) return std::nullopt;
  const auto found = refine_corner(image, pixel);
  if (!found) return std::nullopt;
  if (runs_along(found->edges, slope) && has_sectors(image, found->position, slope, corner))
    return TargetPixel{corner.number, found->position, found->covariance};
  ++dropped;
  return std::nullopt;
}

void drop_far_points(TargetSighting& sighting, const std::vector<TargetPoint>& points, int width, int height) {
  if (sighting.points.size() < 6) return;
  std::vector<PlacePixel> pairs;
  for (const TargetPixel& seen : sighting.points)
    pairs.push_back({points[static_cast<std::size_t>(seen.number)].position.head<2>(), seen.pixel});
  const auto map = fit_plane_map(pairs, width, height);
  if (!map) return;
  std::vector<double> errors;
  for (const PlacePixel& pair : pairs) {
    const auto expected = mapped(*map, pair.place);
    errors.push_back(expected ? (*expected - pair.pixel).norm() : 1e9);
  }
  const double most = std::max(1.0, 6 * median(errors));
  std::vector<TargetPixel> kept;
  for (std::size_t i = 0; i < errors.size(); ++i)
    if (errors[i] <= most) kept.push_back(sighting.points[i]);
  sighting.dropped_points += static_cast<int>(errors.size() - kept.size());
  sighting.points = std::move(kept);
}

}  // namespace handsight
