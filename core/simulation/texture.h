// SPDX-License-Identifier: Apache-2.0
// Soft grey textures for what is no marker: smooth noise without edges, so without X-corners.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace handsight {

/// Smooth noise on a torus: four octaves of value noise, mean 0, largest value about 1, sampled bilinearly. The finest
/// grains are 4 texels, so that nothing in it is an edge.
struct Texture {
  static constexpr int size = 256;  // texels a side; repeats after that
  std::vector<float> values;        // size * size

  /// Value at a place in texels; any x and y, negative ones too, but smaller than 1e6 in magnitude.
  double at(double x, double y) const {
    const double offset = 1 << 20;  // makes truncation a floor
    const auto xi = static_cast<std::int64_t>(x + offset), yi = static_cast<std::int64_t>(y + offset);
    const double fx = x + offset - static_cast<double>(xi), fy = y + offset - static_cast<double>(yi);
    const std::int64_t x0 = xi & (size - 1), x1 = (xi + 1) & (size - 1);
    const std::int64_t y0 = (yi & (size - 1)) * size, y1 = ((yi + 1) & (size - 1)) * size;
    const double top = values[y0 + x0] + fx * (values[y0 + x1] - values[y0 + x0]);
    const double bottom = values[y1 + x0] + fx * (values[y1 + x1] - values[y1 + x0]);
    return top + fy * (bottom - top);
  }
};

Texture make_texture(std::uint64_t seed);

}  // namespace handsight
