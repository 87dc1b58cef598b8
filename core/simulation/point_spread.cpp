// SPDX-License-Identifier: Apache-2.0
#include "simulation/point_spread.h"

#include <algorithm>
#include <cmath>

namespace handsight {

namespace {

/// Share of a Gaussian about 0 that lies below x.
double below(double x, double sigma) {
  if (sigma == 0) return x < 0 ? 0 : 1;
  return 0.5 * std::erfc(-x / (std::sqrt(2.0) * sigma));
}

std::vector<double> exact_shares(double sigma, int radius, double offset) {
  std::vector<double> shares;
  double sum = 0;
  for (int i = -radius; i <= radius; ++i) {
    shares.push_back(below(i + 0.5 - offset, sigma) - below(i - 0.5 - offset, sigma));
    sum += shares.back();
  }
  for (double& share : shares) share /= sum;
  return shares;
}

}  // namespace

PointSpread point_spread(double sigma) {
  PointSpread spread;
  spread.sigma = std::max(0.0, sigma);
  spread.radius = spread.sigma == 0 ? 0 : static_cast<int>(std::ceil(0.5 + 4 * spread.sigma));
  constexpr int places = 64;
  std::vector<double> sum(2 * spread.radius + 1, 0.0);
  for (int place = 0; place < places; ++place) {
    const std::vector<double> shares = exact_shares(spread.sigma, spread.radius, (place + 0.5) / places - 0.5);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += shares[i] / places;
  }
  spread.whole_pixel.assign(sum.begin(), sum.end());
  return spread;
}

std::vector<float> shares_at(const PointSpread& spread, double offset) {
  const std::vector<double> shares = exact_shares(spread.sigma, spread.radius, offset);
  return {shares.begin(), shares.end()};
}

std::vector<float> spread_pixels(const std::vector<float>& grey, int width, int height, const PointSpread& spread) {
  const int radius = spread.radius;
  if (radius == 0) return grey;
  std::vector<float> along_rows(grey.size());
  std::vector<float> padded(static_cast<std::size_t>(width) + 2 * radius, 0.0f);
  for (int v = 0; v < height; ++v) {
    std::copy_n(grey.data() + static_cast<std::size_t>(v) * width, width, padded.data() + radius);
    float* out = along_rows.data() + static_cast<std::size_t>(v) * width;
    for (int i = 0; i <= 2 * radius; ++i) {
      const float share = spread.whole_pixel[i];
      for (int u = 0; u < width; ++u) out[u] += share * padded[u + i];
    }
  }
  std::vector<float> result(grey.size());
  for (int v = 0; v < height; ++v) {
    float* out = result.data() + static_cast<std::size_t>(v) * width;
    for (int i = std::max(-radius, -v); i <= std::min(radius, height - 1 - v); ++i) {
      const float share = spread.whole_pixel[radius + i];
      const float* in = along_rows.data() + static_cast<std::size_t>(v + i) * width;
      for (int u = 0; u < width; ++u) out[u] += share * in[u];
    }
  }
  return result;
}

std::vector<float> spread_ones(int length, const PointSpread& spread) {
  std::vector<float> sums(static_cast<std::size_t>(length), 0.0f);
  for (int u = 0; u < length; ++u)
    for (int i = std::max(-spread.radius, -u); i <= std::min(spread.radius, length - 1 - u); ++i)
      sums[static_cast<std::size_t>(u)] += spread.whole_pixel[spread.radius + i];
  return sums;
}

}  // namespace handsight
