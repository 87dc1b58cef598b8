// SPDX-License-Identifier: Apache-2.0
#include "vision/corners/corner_structure.h"

#include <gtest/gtest.h>

#include "vision/corners/corner_images.h"

namespace handsight {
namespace {

// Four sectors round the middle of an image, two of which need not be black or white.
Image sectors(const std::array<double, 4>& levels, double first, double second, double blur) {
  std::mt19937 random(1);
  const auto scene = [&](double u, double v) {
    const double x = u - 32, y = v - 32;
    const bool above = std::cos(first) * y - std::sin(first) * x > 0;
    const bool beyond = std::cos(second) * y - std::sin(second) * x > 0;
    return levels[2 * above + beyond];
  };
  return corner_images::render(65, 65, scene, blur, 0, random);
}

TEST(CrossStructure, FourSectorsSuitACornerWhateverItsBlurAndAngle) {
  for (const double blur : {0.7, 1.2, 2.0})
    for (const double angle : {0.9, 1.2, M_PI / 2, 2.1}) {
      const Image image = sectors({200, 60, 60, 200}, 0.4, 0.4 + angle, blur);
      const auto cross = cross_structure(image, {32, 32}, 20);
      ASSERT_TRUE(cross) << blur << ' ' << angle;
      EXPECT_LT(sector_misfit(*cross), 0.06) << blur << ' ' << angle;
    }
}

TEST(CrossStructure, WhatIsNoSectorsIsMisfit) {
  const auto compute_misfit = [](const auto& wave) {
    CrossStructure cross;
    cross.edges = {0, M_PI / 2};
    for (int i = 0; i < CrossStructure::direction_count; ++i)
      cross.profile[i] = static_cast<float>(130 + 70 * wave(M_PI * i / CrossStructure::direction_count));
    return sector_misfit(cross);
  };
  const auto blurred = [](double angle) { return std::erf(1.6 * std::sin(angle)) * std::erf(1.6 * std::cos(angle)); };
  EXPECT_LT(compute_misfit(blurred), 0.06);
  EXPECT_GT(compute_misfit([&](double angle) { return blurred(angle) + 0.4 * std::sin(6 * angle); }), 0.15);
  EXPECT_GT(compute_misfit([&](double angle) { return blurred(angle) * (angle < 0.8 ? 0.1 : 1.0); }), 0.15);
}

// Where some blur leaves little enough no other needs to be tried; where none does the least is reported.
TEST(SectorMisfit, EndsWhereItIsEnough) {
  for (const double blur : {0.7, 1.2, 2.0, 2.6}) {
    const auto cross = cross_structure(sectors({200, 60, 60, 200}, 0.4, 1.5, blur), {32, 32}, 20);
    ASSERT_TRUE(cross) << blur;
    const double least = sector_misfit(*cross);
    EXPECT_EQ(sector_misfit(*cross, 0.99 * least), least);
    EXPECT_LE(sector_misfit(*cross, least + 0.02), least + 0.02);
    EXPECT_GE(sector_misfit(*cross, least + 0.02), least);
  }
}

}  // namespace
}  // namespace handsight
