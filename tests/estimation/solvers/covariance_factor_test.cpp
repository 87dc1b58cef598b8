// SPDX-License-Identifier: Apache-2.0
#include "estimation/solvers/covariance_factor.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <random>

#include "estimation/solvers/inverse_parts.h"
#include "estimation/solvers/least_squares.h"

namespace handsight {
namespace {

Eigen::MatrixXd drawn(Eigen::Index rows, Eigen::Index columns, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  Eigen::MatrixXd m(rows, columns);
  for (double& x : m.reshaped()) x = normal(random);
  return m;
}

/// What a reader of covariances looks at: the least eigenvalue of the correlations, and the largest of these.
struct Correlations {
  double least_eigenvalue = 0, largest = 0;
};

Correlations correlations_of(const Eigen::MatrixXd& covariance) {
  const Eigen::VectorXd inverse = covariance.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd c = inverse.asDiagonal() * covariance * inverse.asDiagonal();
  return {Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(c).eigenvalues().minCoeff(), c.cwiseAbs().maxCoeff()};
}

TEST(CovarianceFactor, GivesItsCovarianceBack) {
  std::mt19937_64 random(1);
  const Eigen::MatrixXd f = drawn(7, 4, random);
  const Eigen::MatrixXd covariance = covariance_from(f);
  EXPECT_LT((covariance - f * f.transpose()).norm(), 1e-14 * covariance.norm());
  EXPECT_EQ(covariance, covariance.transpose());
  const Eigen::MatrixXd again = make_factor(covariance);
  EXPECT_LT((covariance_from(again) - covariance).norm(), 1e-13 * covariance.norm());
}

TEST(CovarianceFactor, OfWhatRoundingLeftNegativeIsThatOfTheNearestCovariance) {
  Eigen::MatrixXd off = Eigen::MatrixXd::Identity(3, 3);
  off(0, 1) = off(1, 0) = 1 + 1e-5;  // a correlation beyond 1
  off = Eigen::Vector3d(1e-7, 1, 1e4).asDiagonal() * off * Eigen::Vector3d(1e-7, 1, 1e4).asDiagonal();
  const Eigen::MatrixXd mended = covariance_from(make_factor(off));
  const Correlations c = correlations_of(mended);
  EXPECT_GE(c.least_eigenvalue, -1e-14);
  EXPECT_LE(c.largest, 1 + 1e-14);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(mended(i, i), off(i, i), 1e-5 * off(i, i));
  EXPECT_TRUE(make_factor(Eigen::MatrixXd::Zero(2, 2)).isZero(0));
}

TEST(CovarianceFactor, SaysThatNothingIsKnownOfWhatIsNotFinite) {
  Eigen::MatrixXd off = Eigen::MatrixXd::Identity(2, 2);
  off(1, 1) = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(make_factor(off).array().isNaN().all());
}

TEST(CovarianceFactor, OfAnInverseIsThatOfThePseudoInverse) {
  std::mt19937_64 random(2);
  Eigen::MatrixXd rows = drawn(20, 6, random);
  rows.col(4).setZero();          // not part of the problem
  rows.col(5) = 2 * rows.col(1);  // cannot be distinguished
  const Eigen::MatrixXd h = rows.transpose() * rows;
  int left_out = 0;
  const Eigen::MatrixXd inverse = pseudo_inverse(h, &left_out);
  EXPECT_EQ(left_out, 1);
  EXPECT_LT((covariance_from(pseudo_inverse_factor(h)) - inverse).norm(), 1e-13 * inverse.norm());
}

/// Numbers of which one combination is known 1e5 times less than the others: the sandwich keeps its digits, and the
/// product of the matrices has lost those of the small variance.
TEST(CovarianceFactor, OfASandwichStaysOneWhereADirectionIsHardlyKnown) {
  std::mt19937_64 random(3);
  for (int draw = 0; draw < 20; ++draw) {
    Eigen::MatrixXd rows = drawn(60, 5, random);
    rows.col(3) = rows.col(0) + rows.col(1) + 1e-5 * rows.col(3);
    const Eigen::MatrixXd h = rows.transpose() * rows;
    const Eigen::MatrixXd scattered = drawn(60, 1, random).col(0).asDiagonal() * rows;
    const Eigen::MatrixXd middle = scattered.transpose() * scattered;
    const Eigen::MatrixXd covariance = covariance_from(sandwich_factor(pseudo_inverse_factor(h), middle));
    const Correlations c = correlations_of(covariance);
    EXPECT_GE(c.least_eigenvalue, -1e-14);
    EXPECT_LE(c.largest, 1 + 1e-14);
    using Exact = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
    const Exact inverse = Exact(h.cast<long double>()).inverse();
    const Eigen::MatrixXd exact = (inverse * middle.cast<long double>() * inverse).cast<double>();
    for (int i = 0; i < 5; ++i) EXPECT_NEAR(covariance(i, i), exact(i, i), 1e-3 * exact(i, i)) << i;
  }
}

}  // namespace
}  // namespace handsight
