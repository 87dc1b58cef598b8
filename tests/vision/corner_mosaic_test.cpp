// SPDX-License-Identifier: Apache-2.0
#include "vision/corner_mosaic.h"

#include <gtest/gtest.h>

#include "vision/corner_camera.h"

namespace handsight {
namespace {

using corner_images::Conditions;
using corner_images::Mosaic;
using corner_images::take;

TEST(CornerMosaic, TellsDemosaicedImagesFromOthers) {
  std::mt19937 random(1);
  for (int i = 0; i < 6; ++i) {
    EXPECT_LT(mosaic_ratio(take({}, random).image), kLeastMosaicRatio);
    EXPECT_LT(mosaic_ratio(take({.gamma = {2.2, 2.2}, .quality = {75, 95}}, random).image), kLeastMosaicRatio);
    EXPECT_GT(mosaic_ratio(take({.mosaic = Mosaic::bilinear}, random).image), kLeastMosaicRatio);
  }
}

TEST(CornerMosaic, AnyImageHasARatio) {
  for (const int size : {0, 1, 3, 4, 5, 40}) EXPECT_EQ(mosaic_ratio(Image(size, size, 90)), 1);
}

TEST(CornerMosaic, SmoothingTakesAwayWhatHasAPeriodOfTwo) {
  Image image(40, 40);
  for (int v = 0; v < 40; ++v)
    for (int u = 0; u < 40; ++u) image.row(v)[u] = static_cast<std::uint8_t>(100 + ((u + v) & 1 ? 20 : -20));
  const auto part = smoothed_part(image, {20, 15}, 6);
  ASSERT_TRUE(part);
  EXPECT_EQ(part->origin, Eigen::Vector2i(14, 9));
  EXPECT_EQ(part->image.width, 13);
  for (const std::uint8_t value : part->image.pixels) EXPECT_EQ(value, 100);
  EXPECT_FALSE(smoothed_part(image, {6, 15}, 6));
}

}  // namespace
}  // namespace handsight
