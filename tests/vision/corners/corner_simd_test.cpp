// SPDX-License-Identifier: Apache-2.0
#include "vision/corners/corner_simd.h"

#include <gtest/gtest.h>

#include "base/threads.h"
#include "vision/corners/corner_camera.h"
#include "vision/corners/corner_candidates.h"
#include "vision/corners/corner_detector.h"
#include "vision/corners/corner_truth.h"

namespace handsight {
namespace {

std::vector<Corner> detect(const Image& image, bool wide) {
  const bool has = has_wide_simd();
  has_wide_simd() = wide;
  auto corners = detect_corners(image);
  has_wide_simd() = has;
  return corners;
}

TEST(Simd, ResultsAreTheSameBitByBitWhateverTheProcessorHas) {
  if (!has_wide_simd()) GTEST_SKIP() << "this processor has no wide lanes to compare with";
  std::mt19937 random(4);
  std::vector<Image> images = {corner_images::busy_scene(54, 4, random)};
  for (const double shade : {1.0, 0.6})  // sharp and blurred, in light and beside a shadow
    for (int i = 0; i < 20; ++i) images.push_back(corner_images::draw({.shade = {shade, shade}}, random).image);
  std::size_t found = 0;
  for (const Image& image : images) {
    const auto wide = detect(image, true), narrow = detect(image, false);
    ASSERT_EQ(wide.size(), narrow.size());
    found += wide.size();
    for (std::size_t i = 0; i < wide.size(); ++i) {
      EXPECT_EQ(wide[i].position, narrow[i].position);
      EXPECT_EQ(wide[i].covariance, narrow[i].covariance);
      EXPECT_EQ(wide[i].strength, narrow[i].strength);
    }
  }
  EXPECT_GT(found, 80U);
}

TEST(Threads, ResultsAreTheSameBitByBitHoweverManyThereAre) {
  std::mt19937 random(6);
  const Image image =
      corner_images::take({.width = 1500, .height = 1100, .ground = corner_images::Ground::things}, random).image;
  ASSERT_TRUE(is_worth_threads(image));
  std::vector<std::vector<Corner>> all;
  for (const int threads : {1, 2, 5}) {
    most_threads() = threads;
    all.push_back(detect_corners(image));
  }
  most_threads() = 0;
  EXPECT_GT(all.front().size(), 100U);
  for (const auto& corners : all) {
    ASSERT_EQ(corners.size(), all.front().size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
      EXPECT_EQ(corners[i].position, all.front()[i].position);
      EXPECT_EQ(corners[i].covariance, all.front()[i].covariance);
    }
  }
}

TEST(Simd, ErfAndBellAreExactToTheirPolynomials) {
  Simd x, erf, bell;
  for (float from = -8; from < 8; from += 0.08f) {
    for (int i = 0; i < simd_lanes; ++i) x[i] = from + 0.01f * static_cast<float>(i);
    erf_and_bell(x, erf, bell);
    for (int i = 0; i < simd_lanes; ++i) {
      EXPECT_NEAR(erf[i], std::erf(x[i]), 3e-5);
      EXPECT_NEAR(bell[i], std::exp(-x[i] * x[i]), 3e-6);
    }
  }
}

}  // namespace
}  // namespace handsight
