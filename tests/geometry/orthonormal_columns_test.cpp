// SPDX-License-Identifier: Apache-2.0
#include "geometry/orthonormal_columns.h"

#include <gtest/gtest.h>

#include <random>

namespace handsight {
namespace {

TEST(OrthonormalColumns, SpanWhatTheColumnsSpan) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  for (const Eigen::Index rows : {6, 7, 24, 200}) {
    const Eigen::MatrixXd columns = Eigen::MatrixXd::NullaryExpr(rows, 6, [&] { return normal(random); });
    const Eigen::MatrixXd q = orthonormal_columns(columns);
    ASSERT_EQ(q.rows(), rows);
    ASSERT_EQ(q.cols(), 6);
    // Householder's reflections are orthonormal to rounding, however many rows there are.
    EXPECT_LT((q.transpose() * q - Eigen::MatrixXd::Identity(6, 6)).norm(), 1e-14);
    EXPECT_LT((columns - q * (q.transpose() * columns)).norm(), 1e-14 * columns.norm());
  }
}

TEST(OrthonormalColumns, AreOrthonormalWhereTheColumnsDependOnEachOther) {
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(8, 3);
  columns.col(0).setLinSpaced(1, 8);
  columns.col(1) = 2 * columns.col(0);
  const Eigen::MatrixXd q = orthonormal_columns(columns);
  EXPECT_LT((q.transpose() * q - Eigen::MatrixXd::Identity(3, 3)).norm(), 1e-14);
  EXPECT_LT((columns - q * (q.transpose() * columns)).norm(), 1e-14 * columns.norm());
}

}  // namespace
}  // namespace handsight
