// SPDX-License-Identifier: Apache-2.0
#include "estimation/solvers/learned_step.h"

#include <gtest/gtest.h>

#include <random>

namespace handsight {
namespace {

/// A cost whose curvature is `bend` times what its equations say along each of n directions, of any lengths.
struct Bowl {
  Eigen::MatrixXd information, curvature;
  Eigen::VectorXd bottom;

  explicit Bowl(const std::vector<double>& bend) {
    const auto n = static_cast<Eigen::Index>(bend.size());
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    Eigen::MatrixXd across(n, n);
    for (double& x : across.reshaped()) x = normal(random);
    for (Eigen::Index i = 0; i < n; ++i) across.col(i) *= std::pow(10.0, static_cast<double>(i % 4));
    information = across * across.transpose();
    curvature = across * Eigen::Map<const Eigen::VectorXd>(bend.data(), n).asDiagonal() * across.transpose();
    bottom = Eigen::VectorXd::LinSpaced(n, 1, 2);
  }

  Eigen::VectorXd gradient_at(const Eigen::VectorXd& x) const { return curvature * (bottom - x); }
  Eigen::VectorXd plain_at(const Eigen::VectorXd& x) const { return information.ldlt().solve(gradient_at(x)); }

  /// Steps until less than a billionth of the way is left, in the metric of the curvature.
  int steps_down(bool learns) const {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(bottom.size());
    const auto left = [&] { return (x - bottom).dot(curvature * (x - bottom)); };
    const double least = 1e-18 * left();
    LearnedStep learned;
    int steps = 0;
    for (; steps < 500 && left() > least; ++steps) {
      const Eigen::VectorXd step = learns ? learned.next(plain_at(x), information, gradient_at(x)) : plain_at(x);
      learned.took(step, true);
      x += step;
    }
    return steps;
  }
};

TEST(LearnedStep, IsPlainWhereTheEquationsAreRight) {
  const Bowl bowl({1, 1, 1, 1, 1, 1});
  EXPECT_LE(bowl.steps_down(true), 2);
}

TEST(LearnedStep, GoesTheWholeWayWhereStepsAreTooShort) {
  const Bowl bowl({1, 1, 0.05, 1, 1, 1, 1, 1});
  EXPECT_GT(bowl.steps_down(false), 200);
  EXPECT_LE(bowl.steps_down(true), 4);
}

TEST(LearnedStep, EndsWhereStepsGoTooFar) {
  const Bowl bowl({1, 2.1, 1, 1, 1, 0.2, 1, 1.9});
  EXPECT_EQ(bowl.steps_down(false), 500) << "farther away with every step";
  EXPECT_LE(bowl.steps_down(true), 12);
}

TEST(LearnedStep, ReachesLessFarWhereItWasRefused) {
  const Bowl bowl({1, 1, 0.05, 1});
  LearnedStep learned;
  Eigen::VectorXd x = Eigen::VectorXd::Zero(4);
  for (int i = 0; i < 2; ++i) {
    const Eigen::VectorXd step = bowl.plain_at(x);
    learned.next(step, bowl.information, bowl.gradient_at(x));
    learned.took(step, false);
    x += step;
  }
  const auto size = [&] {
    const Eigen::VectorXd s = learned.next(bowl.plain_at(x), bowl.information, bowl.gradient_at(x));
    return std::sqrt(s.dot(bowl.information * s) / bowl.plain_at(x).dot(bowl.information * bowl.plain_at(x)));
  };
  const double first = size();
  EXPECT_GT(first, 8);
  learned.refused();
  EXPECT_NEAR(size(), first / 4, 1e-6 * first);
  learned.refused();
  EXPECT_FALSE(learned.has_learned());
  EXPECT_NEAR(size(), 1, 1e-9);
}

}  // namespace
}  // namespace handsight
