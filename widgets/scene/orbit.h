// SPDX-License-Identifier: GPL-3.0-or-later
// The eye of the 3D view: it looks at a point from a direction, z up; it never rolls.
#pragma once

#include <vector>

#include "geometry/rigid.h"

class vtkCamera;

namespace handsight::widgets {

struct Orbit {
  Vector3 target{0, 0, 0.5};  // m, root frame
  double azimuth = 0.7;       // rad, of the eye as seen from the target, from x to y
  double elevation = 0.35;    // rad, above the horizon
  double distance = 3.5;      // m

  static constexpr double view_angle = 30;  // deg, vertical

  void turn(double by_azimuth, double by_elevation);
  /// Moves the target so that what lies at its depth follows the pointer; px of a view `height` px high.
  void pan(double right_px, double down_px, double height_px);
  void zoom(double factor);
  /// Far enough away to see a ball round a point.
  void see(const Vector3& center, double radius);
  /// The nearest from which all these points (m, root frame) are seen in a view `aspect` times as wide as high, with a
  /// little room round them and below what covers this share of the view's height along its upper edge.
  void see_points(const std::vector<Vector3>& points, double aspect, double covered_above);
  /// From the eye to the target.
  Vector3 direction() const;
  Vector3 eye() const;
  void apply(vtkCamera& camera) const;
};

}  // namespace handsight::widgets
