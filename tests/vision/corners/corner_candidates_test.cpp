// SPDX-License-Identifier: Apache-2.0
#include "vision/corners/corner_candidates.h"

#include <gtest/gtest.h>

#include <random>

#include "vision/corners/corner_structure.h"
#include "vision/corners/corner_truth.h"

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

// What a smaller image left there is written over, in the memory that it had.
TEST(SaddleCandidates, WriteOverAnImageOfHalfTheSize) {
  std::mt19937 random(3);
  Image image(120, 90), half(60, 45, 7), fresh;
  for (std::uint8_t& pixel : image.pixels) pixel = static_cast<std::uint8_t>(random());
  const std::uint8_t* const before = half.pixels.data();
  saddle_candidates(image, 20, 2, &half), saddle_candidates(image, 20, 2, &fresh);
  EXPECT_EQ(half.pixels.data(), before);
  EXPECT_EQ(half.pixels, fresh.pixels);
}

TEST(SaddleCandidates, KnowWhatTheirRingsMayBeOf) {
  std::mt19937 random(4);
  const Image image = corner_images::busy_scene(54, 4, random);
  std::size_t crosses = 0, none = 0;
  for (const CornerCandidate& candidate : saddle_candidates(image, 20, 4)) {
    const Eigen::Vector2i pixel = (candidate.position.array() + 0.5).cast<int>();
    EXPECT_EQ(candidate.ring, may_be_cross(image, pixel, 20, 4));
    ++(candidate.ring ? crosses : none);
  }
  EXPECT_GT(crosses, 50U);
  EXPECT_GT(none, 50U);
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
  for (const CornerCandidate& candidate : saddle_candidates(image, 20, 2))
    found |= (candidate.position - Eigen::Vector2d(959.5, 919.5)).norm() < 2;
  EXPECT_TRUE(found);
}

// A large image is looked at in bands of rows, a smaller one at once: what they have in common has the same saddles.
TEST(SaddleCandidates, DoNotDependOnTheBandsOfALargeImage) {
  std::mt19937 random(5);
  Image large(1300, 1300);
  for (std::uint8_t& pixel : large.pixels) pixel = static_cast<std::uint8_t>(random());
  for (int top = 0; top <= 200; top += 200) {
    Image part(1300, 1100);
    std::copy_n(large.row(top), part.pixels.size(), part.pixels.begin());
    Image half_of_large, half_of_part;
    const auto inside = [&](const Image& image, int from, Image& half) {
      std::vector<CornerCandidate> kept;
      for (CornerCandidate candidate : saddle_candidates(image, 60, 2, &half)) {
        candidate.position.y() += from - top;
        if (candidate.position.y() > 20 && candidate.position.y() < 1080) kept.push_back(candidate);
      }
      return kept;
    };
    const auto of_large = inside(large, 0, half_of_large), of_part = inside(part, top, half_of_part);
    ASSERT_EQ(of_large.size(), of_part.size());
    EXPECT_GT(of_large.size(), 1000U);
    for (std::size_t i = 0; i < of_large.size(); ++i) {
      EXPECT_EQ(of_large[i].position, of_part[i].position);
      EXPECT_EQ(of_large[i].saddle, of_part[i].saddle);
    }
    EXPECT_TRUE(std::equal(half_of_part.pixels.begin(), half_of_part.pixels.end(), half_of_large.row(top / 2)));
  }
}

}  // namespace
}  // namespace handsight
