// SPDX-License-Identifier: Apache-2.0
#include "vision/corners/corner_noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace handsight {

double image_noise(const Image& image, int places) {
  constexpr double upper_quartile = 1.1503;  // of |x| where x is normal with sigma 1
  constexpr int most_rest = 8 * 255;
  constexpr double mask_norm = 6;  // root of the sum of the mask's squares
  if (image.width < 3 || image.height < 3) return 0;
  const double pixels = static_cast<double>(image.width) * image.height;
  const int stride = std::max(1, static_cast<int>(std::sqrt(pixels / places)));
  std::vector<int> counts(most_rest + 1, 0);  // by how large the rest is there
  int all = 0;
  for (int v = 1; v + 1 < image.height; v += stride) {
    const std::uint8_t *up = image.row(v - 1), *at = image.row(v), *down = image.row(v + 1);
    for (int u = 1; u + 1 < image.width; u += stride)
      ++counts[std::abs(up[u - 1] + up[u + 1] + down[u - 1] + down[u + 1] -
                        2 * (up[u] + at[u - 1] + at[u + 1] + down[u]) + 4 * at[u])],
          ++all;
  }
  int rest = -1;
  for (int below = 0; below <= all * 3 / 4; below += counts[rest]) ++rest;
  return rest / (upper_quartile * mask_norm);
}

double measure_chequer(const Image& image, const Eigen::Vector2i& centre, int reach) {
  std::array<double, 2> squares{1, 1};
  const int left = std::max(centre.x() - reach, 1), right = std::min(centre.x() + reach, image.width - 2);
  const int top = std::max(centre.y() - reach, 1), bottom = std::min(centre.y() + reach, image.height - 2);
  for (int v = top; v <= bottom; ++v) {
    const std::uint8_t *up = image.row(v - 1), *at = image.row(v), *down = image.row(v + 1);
    for (int u = left; u <= right; ++u) {
      const int rough =
          up[u - 1] + up[u + 1] + down[u - 1] + down[u + 1] - 2 * (up[u] + at[u - 1] + at[u + 1] + down[u]) + 4 * at[u];
      squares[(u + v) & 1] += rough * rough;
    }
  }
  return std::log(squares[0] / squares[1]);
}

}  // namespace handsight
