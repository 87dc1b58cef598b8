// SPDX-License-Identifier: Apache-2.0
// Which X-corners are neighbours on a board: an edge leads from one to the other, whatever lens has bent it.
#pragma once

#include <array>
#include <vector>

#include "geometry/rigid.h"
#include "vision/corners/corner_options.h"
#include "vision/image/image.h"

namespace handsight {

/// A corner seen as four rays: along its two edges forth and back, in the order of their angle from x to y.
struct RayCorner {
  Vector2 position = Vector2::Zero();  // px
  std::array<double, 4> angles{};      // rad, ascending, the first in [0, pi)
  bool is_dark_after_first = false;    // the sector from the first ray to the second is darker than its neighbours
  bool is_dark_after(std::size_t ray) const { return (ray % 2 == 0) == is_dark_after_first; }
};
RayCorner ray_corner(const Image& image, const Corner& corner);

/// Where a ray ends: the neighbour and which of its rays comes back.
struct CornerLink {
  int corner = -1;  // none
  std::size_t ray = 0;
  double cost = 0;  // px: the way there, longer for a way with bends that are no arc
};

/// The neighbours of every corner by ray. Each is the nearest along an arc (a straight line that a lens has bent)
/// whose sides have the same colours at both ends, has the other as its own, and is about as far as the one on the
/// other side.
std::vector<std::array<CornerLink, 4>> link_corners(const std::vector<RayCorner>& corners);

}  // namespace handsight
