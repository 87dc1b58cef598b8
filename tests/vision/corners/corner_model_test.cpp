// SPDX-License-Identifier: Apache-2.0
#include "vision/corners/corner_model.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "vision/corners/corner_images.h"
#include "vision/corners/corner_structure.h"

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

// A product of two blurred edges would have to turn them by 0.1 to 0.25 rad, and to take them for more blurred, to look
// like edges that cross askew and are blurred together.
TEST(FitCorner, EdgesThatCrossAskewAreBlurredTogether) {
  for (const double between : {1.57, 1.2, 0.95, 0.8})
    for (const double blur : {1.0, 2.0, 2.8}) {
      std::mt19937 random(7);
      const double first = 0.4, second = first + between;
      const Eigen::Vector2d corner(32.3, 31.8);
      const auto scene = [&](double u, double v) {
        const double x = u - corner.x(), y = v - corner.y();
        const bool one = std::cos(first) * y > std::sin(first) * x, other = std::cos(second) * y > std::sin(second) * x;
        return one == other ? 180.0 : 60.0;
      };
      const Image image = corner_images::render(65, 65, scene, blur, 0.5, random);
      const auto cross = cross_structure(image, corner, 20);
      ASSERT_TRUE(cross) << between << " rad, blur " << blur;
      const auto fit = fit_corner(image, corner, *cross, 0.5);
      ASSERT_TRUE(fit) << between << " rad, blur " << blur;
      EXPECT_LT((fit->model.position - corner).norm(), 0.02) << between << " rad, blur " << blur;
      for (int i = 0; i < 2; ++i) {
        const double own = fit->model.edges[i], one = std::sin(own - first), other = std::sin(own - second);
        EXPECT_LT(std::min(std::abs(one), std::abs(other)), 0.03) << between << " rad, blur " << blur;
      }
      EXPECT_NEAR(fit->model.blur, std::hypot(blur, std::sqrt(1 / 12.0)), 0.03 * blur) << between << " rad";
      EXPECT_LT(fit->noise, 1.0) << between << " rad, blur " << blur;
    }
}

}  // namespace
}  // namespace handsight
