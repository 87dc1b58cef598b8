// SPDX-License-Identifier: GPL-3.0-or-later
// The triangle of the markers as its panel shows it: markers, sides, and whether it will do.
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "geometry/rigid.h"

namespace handsight::widgets {

/// One marker as it stands: where it is in each image and in space.
struct TriangleMarker {
  int number = 0;
  bool has_left = false, has_right = false;
  std::optional<Vector3> in_left_camera;  // m; absent: not triangulated
  std::optional<double> depth_sigma_m;
  std::optional<double> epipolar_distance;  // px
};

struct TriangleSide {
  int from = 0, to = 0;
  double length_mm = 0;
  std::optional<double> sigma_mm;
};

/// How good the triangle is, in words.
enum class TriangleVerdict { waiting, good, care, bad };

struct TriangleState {
  std::vector<TriangleMarker> markers;
  std::vector<TriangleSide> sides;
  TriangleVerdict verdict = TriangleVerdict::waiting;
  QString sentence;  // what is next, or why it will not do
  QString action;    // a button beside it; empty: none
  std::vector<TriangleMarker>
      known;                // how the markers are numbered elsewhere, in any frame; drawn while few are placed
  bool can_use = false;     // the main button
  bool can_discard = true;  // the other one
  int selected_marker = -1;
};

}  // namespace handsight::widgets
