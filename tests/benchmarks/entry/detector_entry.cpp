// SPDX-License-Identifier: Apache-2.0
// The detector of one state of the sources behind names of C, so that a program can load two of them.
#include <algorithm>
#include <vector>

#include "vision/corners/corner_detector.h"

extern "C" {

/// Detects the corners of a grey image without padding; returns how many there are. The first `most` are written to
/// `corners`, five numbers each: position (px), covariance's uu, uv, vv (px^2).
[[gnu::visibility("default")]] int handsight_detect(const unsigned char* pixels, int width, int height, double* corners,
                                                    int most) {
  thread_local handsight::Image image;
  if (image.width != width || image.height != height) image = handsight::Image(width, height);
  std::copy_n(pixels, image.pixels.size(), image.pixels.begin());
  const std::vector<handsight::Corner> found = handsight::detect_corners(image);
  for (int i = 0; i < std::min(most, static_cast<int>(found.size())); ++i) {
    const handsight::Corner& c = found[static_cast<std::size_t>(i)];
    const double numbers[5] = {c.position.x(), c.position.y(), c.covariance(0, 0), c.covariance(0, 1),
                               c.covariance(1, 1)};
    std::copy_n(numbers, 5, corners + 5 * i);
  }
  return static_cast<int>(found.size());
}
}
