// SPDX-License-Identifier: Apache-2.0
// The curve through what a residual follows.
#include "diagnosis/residuals/trend.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace handsight {
namespace {

struct Points {
  Eigen::VectorXd x, y;
};

/// y = f(x) at places in no order, with noise.
template <class Function>
Points points(int count, double noise, Function f, unsigned seed = 11) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-2, 3);
  std::normal_distribution<double> normal;
  Points p{Eigen::VectorXd(count), Eigen::VectorXd(count)};
  for (int i = 0; i < count; ++i) {
    p.x[i] = place(random);
    p.y[i] = f(p.x[i]) + noise * normal(random);
  }
  return p;
}

TEST(Trend, AStraightLineIsItself) {
  const Points p = points(60, 0, [](double x) { return 2 - 3 * x; });
  const auto trend = compute_trend(p.x, p.y);
  ASSERT_GT(trend.size(), 10U);
  EXPECT_DOUBLE_EQ(trend.front().x, p.x.minCoeff());
  EXPECT_DOUBLE_EQ(trend.back().x, p.x.maxCoeff());
  // At the ends the little that keeps the slope finite bends the line by less than a hundredth of its range of 15.
  for (const TrendPoint& t : trend) EXPECT_NEAR(t.y, 2 - 3 * t.x, 0.01 * 15) << t.x;
}

TEST(Trend, TheBandCoversASmoothCurve) {
  const auto curve = [](double x) { return 0.3 * x * x; };
  int inside = 0, all = 0;
  const Points p = points(400, 0.5, curve);
  for (const TrendPoint& t : compute_trend(p.x, p.y)) {
    inside += t.low <= curve(t.x) && curve(t.x) <= t.high;
    EXPECT_LT(t.low, t.high);
    ++all;
  }
  // Two sigma would be 95 %; what a line over a third of the points rounds off costs some of them.
  EXPECT_GT(inside, 0.7 * all);
}

TEST(Trend, OfFewPlacesItIsTheMeanAtEach) {
  Eigen::VectorXd x(8), y(8);
  x << 1, -1, 1, -1, 1, -1, 1, -1;
  y << 4, 0, 6, 2, 4, 0, 6, 2;
  const auto trend = compute_trend(x, y);
  ASSERT_EQ(trend.size(), 2U);
  EXPECT_DOUBLE_EQ(trend[0].x, -1);
  EXPECT_DOUBLE_EQ(trend[0].y, 1);
  EXPECT_DOUBLE_EQ(trend[1].y, 5);
  // 0 2 0 2 scatter by 2 / sqrt(3), their mean by half of it.
  EXPECT_NEAR(trend[0].high - trend[0].y, 2 / std::sqrt(3.0), 1e-12);
}

TEST(Trend, FewerThanFourPointsHaveNone) {
  EXPECT_TRUE(compute_trend(Eigen::VectorXd::LinSpaced(3, 0, 1), Eigen::VectorXd::Ones(3)).empty());
}

TEST(Trend, TheOrderOfThePointsDoesNotMatter) {
  const Points p = points(50, 0.2, [](double x) { return std::sin(x); });
  const auto forward = compute_trend(p.x, p.y), backward = compute_trend(p.x.reverse(), p.y.reverse());
  ASSERT_EQ(forward.size(), backward.size());
  for (std::size_t i = 0; i < forward.size(); ++i) EXPECT_NEAR(forward[i].y, backward[i].y, 1e-12);
}

TEST(Trend, WhatFollowsIsExplainedAndNoiseIsNot) {
  const Points follows = points(200, 0.05, [](double x) { return std::sin(x); });
  EXPECT_GT(followed_share(follows.x, follows.y), 0.95);
  // A line through each third of 200 points has some seven numbers: of noise they take up 4 %.
  constexpr int draws = 100;
  double noise_share = 0;
  for (unsigned seed = 0; seed < draws; ++seed) {
    const Points noise = points(
        200, 1, [](double) { return 0.0; }, seed);
    noise_share += followed_share(noise.x, noise.y) / draws;
  }
  EXPECT_LT(noise_share, 0.06);
}

}  // namespace
}  // namespace handsight
