// SPDX-License-Identifier: Apache-2.0
// How light spreads over pixels: a Gaussian, then the square of the pixel, both integrated exactly. Blurring an image
// of finished pixels instead would shift edges by up to 0.02 px, depending on where in the pixel they lie.
#pragma once

#include <span>
#include <vector>

namespace handsight {

/// Shares of light along one axis that pixels -radius ... radius get; each set of shares adds up to 1.
struct PointSpread {
  double sigma = 0;                // px, of the Gaussian; 0: only the pixel's square
  int radius = 0;                  // px
  std::vector<float> whole_pixel;  // of light spread evenly over pixel 0
};

PointSpread point_spread(double sigma);

/// The shares of light that falls at `offset` (px, -0.5 to 0.5) from the centre of pixel 0.
std::vector<float> shares_at(const PointSpread& spread, double offset);

/// Spreads an image of evenly lit pixels, light outside being none.
std::vector<float> spread_pixels(const std::vector<float>& grey, int width, int height, const PointSpread& spread);

/// What `spread_pixels` makes of a row of ones: less than 1 near the ends.
std::vector<float> spread_ones(int length, const PointSpread& spread);

}  // namespace handsight
