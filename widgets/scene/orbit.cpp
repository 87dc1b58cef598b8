// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/orbit.h"

#include <algorithm>
#include <cmath>

namespace handsight::widgets {
namespace {

constexpr double kSteepest = 1.5690;  // rad: never quite straight down, where "up" would be lost

}  // namespace

Vector3 Orbit::direction() const {
  return {-std::cos(elevation) * std::cos(azimuth), -std::cos(elevation) * std::sin(azimuth), -std::sin(elevation)};
}

Vector3 Orbit::eye() const { return target - distance * direction(); }

void Orbit::turn(double by_azimuth, double by_elevation) {
  azimuth = std::remainder(azimuth + by_azimuth, 2 * M_PI);
  elevation = std::clamp(elevation + by_elevation, -kSteepest, kSteepest);
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

void Orbit::see_box(const Vector3& low, const Vector3& high, double aspect) {
  constexpr double used = 0.84;  // of the view: buttons lie along its upper edge
  const double up_slope = used * std::tan(view_angle / 2 * M_PI / 180), right_slope = up_slope * std::max(aspect, 0.1);
  target = (low + high) / 2;
  const Vector3 forward = direction(), right = forward.cross(Vector3::UnitZ()).normalized(), up = right.cross(forward);
  distance = 0.05;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3 at =
        Vector3(corner & 1 ? high.x() : low.x(), corner & 2 ? high.y() : low.y(), corner & 4 ? high.z() : low.z()) -
        target;
    const double aside = std::max(std::abs(up.dot(at)) / up_slope, std::abs(right.dot(at)) / right_slope);
    distance = std::max(distance, aside - forward.dot(at));
  }
  distance = std::min(distance, 50.0);
}

void Orbit::apply(vtkCamera& camera) const {
  camera.SetViewAngle(view_angle);
  camera.SetFocalPoint(target.data());
  camera.SetPosition(eye().data());
  camera.SetViewUp(0, 0, 1);
}

}  // namespace handsight::widgets
