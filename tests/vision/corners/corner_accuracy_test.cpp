// SPDX-License-Identifier: Apache-2.0
#include "vision/corners/corner_accuracy.h"

#include <gtest/gtest.h>

#include "vision/corners/corner_camera.h"
#include "vision/corners/corner_model.h"
#include "vision/corners/corner_odd_system.h"
#include "vision/corners/corner_structure.h"

namespace handsight {
namespace {

// Fits of corners at 32, 32 whose image is made by `scene` with white noise, which `blur_of_noise` px of smoothing
// correlate.
std::vector<std::pair<CornerFit, Image>> fits(const corner_images::Scene& scene, double noise, bool is_correlated,
                                              int count) {
  std::mt19937 random(3);
  std::vector<std::pair<CornerFit, Image>> all;
  const cv::Mat exact = corner_images::exact_image(65, 65, scene, 1);
  std::normal_distribution<float> normal(0, 1);
  for (int i = 0; i < count; ++i) {
    cv::Mat grain(65, 65, CV_32F);
    for (int v = 0; v < 65; ++v)
      for (int u = 0; u < 65; ++u) grain.at<float>(v, u) = normal(random);
    if (is_correlated) {
      cv::GaussianBlur(grain, grain, {0, 0}, 0.8);
      grain *= 2 * std::sqrt(M_PI) * 0.8;
    }
    Image image(65, 65);
    for (int v = 0; v < 65; ++v)
      for (int u = 0; u < 65; ++u)
        image.row(v)[u] = static_cast<std::uint8_t>(
            std::clamp(std::lround(exact.at<float>(v, u) + noise * grain.at<float>(v, u)), 0L, 255L));
    const auto cross = cross_structure(image, {32, 32}, 20);
    const auto fit = cross ? fit_corner(image, {32, 32}, *cross, noise) : std::nullopt;
    if (fit) all.push_back({*fit, image});
  }
  return all;
}

double plain(double u, double v) { return ((u < 32.2) == (v < 31.9)) ? 60 : 180; }

struct Outcome {
  double normalised = 0, squares = 0, before = 0;
  Habits habits;
};

Outcome make_outcome(const std::vector<std::pair<CornerFit, Image>>& all, const Eigen::Vector2d& truth) {
  std::vector<OddSystem> systems;
  for (const auto& [fit, image] : all) systems.push_back(*odd_system(image, fit));
  Outcome outcome;
  outcome.habits = learn_habits(systems);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto last = last_step(systems[i], outcome.habits);
    const Eigen::Vector2d move = last->is_needed ? last->move : Eigen::Vector2d::Zero();
    const Eigen::Vector2d error = all[i].first.model.position + move - truth;
    outcome.normalised += error.dot(last->covariance.inverse() * error) / static_cast<double>(all.size());
    outcome.squares += error.squaredNorm() / static_cast<double>(all.size());
    outcome.before += (all[i].first.model.position - truth).squaredNorm() / static_cast<double>(all.size());
  }
  return outcome;
}

TEST(CornerAccuracy, OfWhiteNoiseTheCovarianceIsRight) {
  const auto all = fits(plain, 4, false, 150);
  ASSERT_GT(all.size(), 140u);
  const Outcome outcome = make_outcome(all, {32.2, 31.9});
  EXPECT_GT(outcome.normalised, 1.4);  // 2 is right, 150 corners scatter by 0.16
  EXPECT_LT(outcome.normalised, 2.8);
  for (const double correlation : outcome.habits.correlation) EXPECT_NEAR(correlation, 0, 0.1);
}

// What the next cells leave is the same at opposite points: it moves no corner and is less of a noise than
// it seems where the corner lies between pixels.
TEST(CornerAccuracy, WhatIsSymmetricIsLittleNoise) {
  const auto narrow = [](double u, double v) {
    const double x = u - 32.2, y = v - 31.8;
    return ((x < 0) == (y < 0)) == (std::abs(x) < 5.5) ? 60 : 180;
  };
  const auto all = fits(narrow, 1, false, 60);
  ASSERT_GT(all.size(), 50u);
  double variance = 0;
  for (const auto& [fit, image] : all) {
    EXPECT_GT(fit.noise, 2);  // what they leave is there
    variance += odd_system(image, fit)->variance / static_cast<double>(all.size());
  }
  EXPECT_LT(variance, 5);  // 6.1 where opposite points are taken to the nearest half pixel only
}

TEST(CornerAccuracy, KnowsThatNeighboursShareTheirNoise) {
  const auto all = fits(plain, 4, true, 150);
  ASSERT_GT(all.size(), 130u);
  const Outcome outcome = make_outcome(all, {32.2, 31.9});
  EXPECT_GT(outcome.habits.correlation[0], 0.35);  // a Gaussian of 0.8 px: exp(-1 / 2.56) = 0.68, a third stays hidden
  EXPECT_GT(outcome.normalised, 1);
  EXPECT_LT(outcome.normalised, 4);  // 3.4 here: of sigma a quarter is still missing
}

TEST(CornerAccuracy, FindsBothEdgesBends) {
  const double bend = 0.004;  // 1/px
  const auto bent = [&](double u, double v) {
    const double x = u - 32.2, y = v - 31.9;
    return ((x < 0.5 * bend * y * y) == (y < 0.5 * bend * x * x)) ? 60 : 180;
  };
  const auto all = fits(bent, 1.5, false, 60);
  ASSERT_GT(all.size(), 50u);
  const Outcome outcome = make_outcome(all, {32.2, 31.9});
  EXPECT_NEAR(outcome.habits.bend, bend, 0.4 * bend);
  EXPECT_LT(outcome.squares, 0.25 * outcome.before);
  EXPECT_LT(outcome.normalised, 3);
}

// Bends too small to be sure of move nothing, but sigma knows how far they pull the fit.
TEST(CornerAccuracy, WhatStaysKnowsWhatBendsPullAt) {
  const double bend = 4.5e-4, times = 10;  // 1/px; times that, which the drawn scene resolves
  const auto mean_of = [](double first, double second) {
    const auto bent = [&](double u, double v) {
      const double x = u - 32.2, y = v - 31.9;
      return ((x < 0.5 * first * y * y) == (y < 0.5 * second * x * x)) ? 60 : 180;
    };
    Eigen::Vector2d sum(0, 0);
    const auto all = fits(bent, 1, false, 30);
    for (const auto& one : all) sum += one.first.model.position;
    return Eigen::Vector2d(sum / static_cast<double>(all.size()));
  };
  const Eigen::Vector2d straight = mean_of(0, 0);
  const Eigen::Vector2d by_first = (mean_of(times * bend, 0) - straight) / times;
  const Eigen::Vector2d by_second = (mean_of(0, times * bend) - straight) / times;
  const auto one = fits(plain, 1, false, 1).front();
  const OddSystem system = *odd_system(one.second, one.first);
  Habits bent, none;
  bent.bend = bend, none.bend = 1e-7;
  ASSERT_FALSE(last_step(system, bent)->is_needed);
  const double more = (last_step(system, bent)->covariance - last_step(system, none)->covariance).trace();
  EXPECT_NEAR(more, by_first.squaredNorm() + by_second.squaredNorm(), 0.5 * more);
}

TEST(CornerAccuracy, FindsLightThatIsAdded) {
  const auto glaring = [&](double u, double v) { return 0.7 * plain(u, v) + 1.2 * (u - 32); };
  const auto all = fits(glaring, 1.5, false, 60);
  ASSERT_GT(all.size(), 50u);
  const Outcome outcome = make_outcome(all, {32.2, 31.9});
  EXPECT_LT(outcome.squares, 0.25 * outcome.before);
  EXPECT_LT(outcome.normalised, 3);
}

}  // namespace
}  // namespace handsight
