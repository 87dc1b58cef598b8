// SPDX-License-Identifier: Apache-2.0
#include "vision/corner_model.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "vision/corner_images.h"
#include "vision/corner_structure.h"

namespace handsight {
namespace {

TEST(FitCorner, KnowsThatEdgesNearlyAlongEachOtherLeaveThePositionOpen) {
  int fitted = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> between(0.35, 0.9);
    const double first = 0.1 * seed, second = first + between(random);
    const auto scene = [&](double u, double v) {
      const double x = u - 32, y = v - 32;
      const bool one = std::cos(first) * y > std::sin(first) * x, other = std::cos(second) * y > std::sin(second) * x;
      return one == other ? 70.0 : 120.0;
    };
    const Image image = corner_images::render(65, 65, scene, 1.5, 6, random);
    const auto cross = cross_structure(image, {32, 32}, 20, Lighting::shadowed);
    const auto fit = cross ? fit_corner(image, {32, 32}, *cross, 6) : std::nullopt;
    if (!fit) continue;
    ++fitted;
    EXPECT_TRUE(fit->covariance.allFinite());
    EXPECT_EQ(fit->covariance.llt().info(), Eigen::Success) << seed;
  }
  EXPECT_GT(fitted, 20);
}

}  // namespace
}  // namespace handsight
