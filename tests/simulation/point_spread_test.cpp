// SPDX-License-Identifier: Apache-2.0
#include "simulation/point_spread.h"

#include <gtest/gtest.h>

namespace handsight {
namespace {

struct Moments {
  double sum = 0, mean = 0, variance = 0;
};

Moments moments(const std::vector<float>& shares, int radius) {
  Moments m;
  for (int i = -radius; i <= radius; ++i) {
    m.sum += shares[static_cast<std::size_t>(i + radius)];
    m.mean += i * shares[static_cast<std::size_t>(i + radius)];
    m.variance += i * i * shares[static_cast<std::size_t>(i + radius)];
  }
  m.variance -= m.mean * m.mean;
  return m;
}

TEST(PointSpread, SharesHaveTheMomentsOfGaussianAndSquare) {
  for (const double sigma : {0.5, 0.8, 1.3}) {
    const PointSpread spread = point_spread(sigma);
    for (const double offset : {-0.5, -0.2, 0.0, 0.37}) {
      const Moments m = moments(shares_at(spread, offset), spread.radius);
      EXPECT_NEAR(m.sum, 1, 1e-6);
      EXPECT_NEAR(m.mean, offset, 0.003);  // pixels alias what is as narrow as they are: exact only for wide spreads
      EXPECT_NEAR(m.variance, sigma * sigma + 1.0 / 12, 0.02);
    }
    EXPECT_NEAR(moments(spread.whole_pixel, spread.radius).variance, sigma * sigma + 1.0 / 6, 0.005);
  }
}

TEST(PointSpread, WithoutBlurLightStaysInItsPixel) {
  const PointSpread spread = point_spread(0);
  EXPECT_EQ(shares_at(spread, 0.49), std::vector<float>{1});
  EXPECT_EQ(spread_pixels({1, 2, 3, 4}, 2, 2, spread), (std::vector<float>{1, 2, 3, 4}));
}

TEST(PointSpread, KeepsTheLightAndKnowsWhatLeavesTheImage) {
  const PointSpread spread = point_spread(0.9);
  std::vector<float> grey(41 * 31, 0.0f);
  grey[15 * 41 + 20] = 100;
  double sum = 0;
  for (const float value : spread_pixels(grey, 41, 31, spread)) sum += value;
  EXPECT_NEAR(sum, 100, 1e-3);
  const std::vector<float> even = spread_pixels(std::vector<float>(41 * 31, 7.0f), 41, 31, spread);
  const std::vector<float> along_u = spread_ones(41, spread), along_v = spread_ones(31, spread);
  for (int v = 0; v < 31; ++v)
    for (int u = 0; u < 41; ++u)
      EXPECT_NEAR(even[static_cast<std::size_t>(v) * 41 + u] /
                      (along_u[static_cast<std::size_t>(u)] * along_v[static_cast<std::size_t>(v)]),
                  7, 1e-4);
}

}  // namespace
}  // namespace handsight
