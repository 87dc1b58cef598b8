// SPDX-License-Identifier: Apache-2.0
// The image at a half, a quarter ... of the resolution: what is blurred or sharpened there is less so.
#pragma once

#include <Eigen/Core>

namespace handsight {

/// px, where a point of an image halved `times` times lies in the whole one, and back. Halved: each pixel is the mean
/// of 2 x 2, an odd last row or column is left out.
inline Eigen::Vector2d in_whole(const Eigen::Vector2d& position, int times) {
  const double scale = 1 << times;
  return scale * position.array() + 0.5 * (scale - 1);
}
inline Eigen::Vector2d in_halved(const Eigen::Vector2d& position, int times) {
  const double scale = 1 << times;
  return (position.array() - 0.5 * (scale - 1)) / scale;
}

}  // namespace handsight
