// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/rigid.h"
#include "vision/image/image.h"

namespace handsight {

/// Grey level between pixels, bilinear; the place is inside by half a pixel or is drawn there.
inline double grey_at(const Image& image, const Vector2& pixel) {
  const double u = std::min(std::max(pixel.x(), 0.0), image.width - 1.001),
               v = std::min(std::max(pixel.y(), 0.0), image.height - 1.001);
  const int column = static_cast<int>(u), row = static_cast<int>(v);
  const double right = u - column, down = v - row;
  const std::uint8_t *above = image.row(row) + column, *below = image.row(row + 1) + column;
  return (1 - down) * ((1 - right) * above[0] + right * above[1]) + down * ((1 - right) * below[0] + right * below[1]);
}

inline bool is_inside(const Image& image, const Vector2& pixel, double margin = 0) {
  return pixel.x() >= margin && pixel.y() >= margin && pixel.x() <= image.width - 1 - margin &&
         pixel.y() <= image.height - 1 - margin;  // not for NaN
}

}  // namespace handsight
