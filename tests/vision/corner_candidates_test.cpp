// SPDX-License-Identifier: Apache-2.0
#include "vision/corner_candidates.h"

#include <gtest/gtest.h>

#include <random>

#include "vision/corner_images.h"

namespace handsight {
namespace {

TEST(SaddleCandidates, GiveTheImageAtHalfTheResolution) {
  std::mt19937 random(1);
  for (const auto& [width, height] : {std::pair{31, 45}, std::pair{64, 14}, std::pair{9, 9}, std::pair{1, 3}}) {
    Image image(width, height), half;
    for (std::uint8_t& pixel : image.pixels) pixel = static_cast<std::uint8_t>(random());
    saddle_candidates(image, 20, 2, &half);
    if (width < 14 || height < 14) continue;
    ASSERT_EQ(half.width, width / 2);
    ASSERT_EQ(half.height, height / 2);
    for (int v = 0; v < half.height; ++v)
      for (int u = 0; u < half.width; ++u) {
        const int sum = image.row(2 * v)[2 * u] + image.row(2 * v)[2 * u + 1] + image.row(2 * v + 1)[2 * u] +
                        image.row(2 * v + 1)[2 * u + 1];
        EXPECT_EQ(half.row(v)[u], (sum + 2) / 4);
      }
  }
}

// Strong texture all over must not take the places of faint corners far from it.
TEST(SaddleCandidates, EveryTileKeepsItsStrongest) {
  std::mt19937 random(2);
  Image image(1024, 1024, 128);
  for (int v = 0; v < 1024; ++v)
    for (int u = 0; u < 800; ++u) image.row(v)[u] = static_cast<std::uint8_t>(random());
  for (int v = 900; v < 940; ++v)
    for (int u = 940; u < 980; ++u) image.row(v)[u] = ((u < 960) == (v < 920)) ? 110 : 140;
  bool found = false;
  for (const Candidate& candidate : saddle_candidates(image, 20, 2))
    found |= (candidate.position - Eigen::Vector2d(959.5, 919.5)).norm() < 2;
  EXPECT_TRUE(found);
}

}  // namespace
}  // namespace handsight
