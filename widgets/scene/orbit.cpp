// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/orbit.h"

#include <vtkCamera.h>

#include <algorithm>
#include <cmath>

namespace handsight::widgets {
namespace {

constexpr double steepest = 1.5690;  // rad: never quite straight down, where "up" would be lost

}  // namespace

Vector3 Orbit::direction() const {
  return {-std::cos(elevation) * std::cos(azimuth), -std::cos(elevation) * std::sin(azimuth), -std::sin(elevation)};
}

Vector3 Orbit::eye() const { return target - distance * direction(); }

void Orbit::turn(double by_azimuth, double by_elevation) {
  azimuth = std::remainder(azimuth + by_azimuth, 2 * M_PI);
  elevation = std::clamp(elevation + by_elevation, -steepest, steepest);
}

void Orbit::pan(double right_px, double down_px, double height_px) {
  const double metres = 2 * distance * std::tan(view_angle / 2 * M_PI / 180) / std::max(height_px, 1.0);
  const Vector3 right = direction().cross(Vector3::UnitZ()).normalized();
  const Vector3 down = direction().cross(right);
  target -= metres * (right_px * right + down_px * down);
}

void Orbit::zoom(double factor) { distance = std::clamp(distance / factor, 0.05, 50.0); }

void Orbit::see(const Vector3& center, double radius) {
  target = center;
  distance = std::clamp(std::max(radius, 0.02) / std::sin(view_angle / 2 * M_PI / 180), 0.05, 50.0);
}

void Orbit::see_points(const std::vector<Vector3>& points, double aspect, double covered_above) {
  if (points.empty()) return;
  constexpr double used = 0.88;
  const double slope = std::tan(view_angle / 2 * M_PI / 180), aside = used * slope * std::max(aspect, 0.1);
  const double below = used * slope, above = std::max(used - 2 * covered_above, 0.3) * slope;
  const Vector3 forward = direction(), right = forward.cross(Vector3::UnitZ()).normalized(), up = right.cross(forward);
  // An edge of the view is a plane through the eye: the points that lie furthest beyond its slope hold it.
  double to_right = -1e300, to_left = -1e300, to_top = -1e300, to_bottom = -1e300, nearest = 1e300;
  for (const Vector3& point : points) {
    const double depth = forward.dot(point), x = right.dot(point), y = up.dot(point);
    to_right = std::max(to_right, x - aside * depth);
    to_left = std::max(to_left, -x - aside * depth);
    to_top = std::max(to_top, y - above * depth);
    to_bottom = std::max(to_bottom, -y - below * depth);
    nearest = std::min(nearest, depth);
  }
  constexpr double closest = 0.05, farthest = 50.0;  // m
  const double back =
      std::min({-(to_right + to_left) / (2 * aside), -(to_top + to_bottom) / (above + below), nearest - closest});
  const double x = (to_right - to_left) / 2, y = (to_top + above * back - to_bottom - below * back) / 2;
  double middle = 0;
  for (const Vector3& point : points) middle += forward.dot(point) / static_cast<double>(points.size());
  distance = std::clamp(middle - back, closest, farthest);
  target = x * right + y * up + (back + distance) * forward;
}

void Orbit::apply(vtkCamera& camera) const {
  camera.SetViewAngle(view_angle);
  camera.SetFocalPoint(target.data());
  camera.SetPosition(eye().data());
  camera.SetViewUp(0, 0, 1);
}

}  // namespace handsight::widgets
