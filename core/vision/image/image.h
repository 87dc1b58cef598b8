// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace handsight {

/// A grey image, 8 bit a pixel, row by row without padding. Pixel (u, v) has its centre at (u, v): the centre
/// of the top left pixel is (0, 0).
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;  // width * height

  Image() = default;
  Image(int width_, int height_, std::uint8_t value = 0)
      : width(width_), height(height_), pixels(static_cast<std::size_t>(width_) * height_, value) {}
  const std::uint8_t* row(int v) const { return pixels.data() + static_cast<std::size_t>(v) * width; }
  std::uint8_t* row(int v) { return pixels.data() + static_cast<std::size_t>(v) * width; }
};

}  // namespace handsight
