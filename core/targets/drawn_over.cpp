// SPDX-License-Identifier: Apache-2.0
#include "targets/drawn_over.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace handsight {
namespace {

/// Grey levels of pure colours: blue, red, magenta, green, cyan, yellow (shares of red, green and blue as `read_image`
/// has them).
constexpr std::array<double, 6> pure_greys{0.114 * 255, 0.299 * 255, 0.413 * 255,
                                           0.587 * 255, 0.701 * 255, 0.886 * 255};

}  // namespace

bool is_drawn_over(const Image& image) {
  constexpr double often = 3e-4, very_often = 3e-3;  // of all pixels
  std::array<int, 256> counts{};
  for (const std::uint8_t pixel : image.pixels) ++counts[pixel];
  const auto pixels = static_cast<double>(std::max<std::size_t>(image.pixels.size(), 1));
  int colours = 0;
  bool is_one_very_often = false;
  for (const double grey : pure_greys)
    for (const int level : {static_cast<int>(std::floor(grey)), static_cast<int>(std::ceil(grey))}) {
      int beside = 0;  // the most of the levels around, the other rounding left out
      for (const int other : {level - 4, level - 3, level - 2, level + 2, level + 3, level + 4})
        beside = std::max(beside, counts[static_cast<std::size_t>(std::clamp(other, 0, 255))]);
      const double excess = counts[static_cast<std::size_t>(level)] - beside;
      if (excess < often * pixels || excess < beside) continue;
      ++colours;
      is_one_very_often = is_one_very_often || excess > very_often * pixels;
      break;
    }
  return colours >= 2 || is_one_very_often;
}

}  // namespace handsight
