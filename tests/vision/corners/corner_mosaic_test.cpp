// SPDX-License-Identifier: Apache-2.0
#include "vision/corners/corner_mosaic.h"

#include <gtest/gtest.h>

#include "vision/corners/corner_accuracy.h"
#include "vision/corners/corner_camera.h"
#include "vision/corners/corner_model.h"
#include "vision/corners/corner_structure.h"

namespace handsight {
namespace {

// An edge along the pixels' rows meets a colour filter's pattern in one phase all along.
TEST(CornerMosaic, KnowsWhereColourFiltersAreBlind) {
  double normalised = 0;
  int count = 0;
  std::mt19937 random(4);
  for (int i = 0; i < 64; ++i) {
    const Eigen::Vector2d truth(32 + i % 8 / 8.0, 32 + i / 8 / 8.0);
    const auto scene = [&](double u, double v) { return ((u < truth.x()) == (v < truth.y())) ? 60 : 180; };
    const cv::Mat seen = corner_images::camera_detail::demosaiced(corner_images::exact_image(65, 65, scene, 0.35),
                                                                  corner_images::Mosaic::bilinear);
    cv::Mat grain(seen.size(), CV_32F), whole;
    std::normal_distribution<float> normal(0, 0.5f);
    for (int n = 0; n < 65 * 65; ++n) grain.at<float>(n / 65, n % 65) = normal(random);
    cv::Mat(seen + grain).convertTo(whole, CV_8U);
    const Image image = corner_images::as_image(whole);
    const auto cross = cross_structure(image, truth, 20);
    const auto fit = cross ? fit_corner(image, truth, *cross, 0.5) : std::nullopt;
    const auto system = fit ? smoothed_odd_system(image, *fit) : std::nullopt;
    const auto last = system ? last_step(*system, learn_habits({&*system, 1})) : std::nullopt;
    if (!last) continue;
    const Eigen::Vector2d error = fit->model.position + last->move - truth;
    normalised += error.dot(last->covariance.inverse() * error), ++count;
  }
  ASSERT_GT(count, 55);
  EXPECT_LT(normalised / count, 4);  // 2 is right
}

}  // namespace
}  // namespace handsight
