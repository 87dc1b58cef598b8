// SPDX-License-Identifier: Apache-2.0
#include "vision/corner_mosaic.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "vision/corner_patch.h"

namespace handsight {

double mosaic_ratio(const Image& image) {
  constexpr double kPlaces = 4000;
  constexpr int kMost = 60;  // of the mask's value: single edges must not say all
  if (image.width < 4 || image.height < 4) return 1;
  const double pixels = static_cast<double>(image.width) * image.height;
  const int stride = std::max(2, static_cast<int>(std::sqrt(pixels / kPlaces)));
  double sums[2] = {1000, 1000};  // where there is hardly any detail its ratio is chance
  const auto detail = [&](const std::uint8_t* up, const std::uint8_t* at, const std::uint8_t* down) {
    return std::min(std::abs(up[-1] + up[1] + down[-1] + down[1] - 2 * (up[0] + at[-1] + at[1] + down[0]) + 4 * at[0]),
                    kMost);
  };
  for (int v = 1; v + 1 < image.height; v += stride)
    for (int u = 1; u + 2 < image.width; u += stride)
      for (int next = 0; next < 2; ++next)
        sums[(u + v + next) & 1] +=
            detail(image.row(v - 1) + u + next, image.row(v) + u + next, image.row(v + 1) + u + next);
  return std::max(sums[0], sums[1]) / std::min(sums[0], sums[1]);
}

std::optional<Part> smoothed_part(const Image& image, const Eigen::Vector2i& centre, int reach) {
  if (!is_inside(image, centre, reach + 1)) return std::nullopt;
  const int side = 2 * reach + 1;
  Part part{Image(side, side), centre.array() - reach};
  for (int v = 0; v < side; ++v) {
    const std::uint8_t* const at = image.row(part.origin.y() + v) + part.origin.x();
    const std::uint8_t *const up = at - image.width, *const down = at + image.width;
    for (int u = 0; u < side; ++u)
      part.image.row(v)[u] = static_cast<std::uint8_t>((up[u - 1] + 2 * up[u] + up[u + 1] + 2 * at[u - 1] + 4 * at[u] +
                                                        2 * at[u + 1] + down[u - 1] + 2 * down[u] + down[u + 1] + 8) >>
                                                       4);
  }
  return part;
}

}  // namespace handsight
