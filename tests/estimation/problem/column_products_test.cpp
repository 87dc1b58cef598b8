// SPDX-License-Identifier: Apache-2.0
#include "estimation/problem/column_products.h"

#include <gtest/gtest.h>

#include <random>

#include "base/threads.h"

namespace handsight {
namespace {

Eigen::MatrixXd random_matrix(Eigen::Index rows, Eigen::Index columns, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return normal(random); });
}

struct Product {
  Eigen::Index rows, a, b;
};

class ColumnProducts : public testing::TestWithParam<Product> {
 protected:
  void TearDown() override { registers_in_use() = widest_; }
  const Registers widest_ = registers_in_use();
};

TEST_P(ColumnProducts, AreThoseOfEigen) {
  const auto [rows, columns_a, columns_b] = GetParam();
  const Eigen::MatrixXd a = random_matrix(rows, columns_a, 1), b = random_matrix(rows, columns_b, 2);
  const double rounding = 1e-15 * static_cast<double>(rows);  // of sums of so many
  const auto agree = [&](const Eigen::MatrixXd& ours, const Eigen::MatrixXd& theirs, const Eigen::MatrixXd& sizes) {
    EXPECT_TRUE(((ours - theirs).array().abs() <= rounding * sizes.array()).all());
  };
  agree(column_products(a, b), a.transpose() * b, a.cwiseAbs().transpose() * b.cwiseAbs());
  agree(column_products(a), a.transpose() * a, a.cwiseAbs().transpose() * a.cwiseAbs());
}

TEST_P(ColumnProducts, AreTheSameBitByBitInAllRegistersThatTheProcessorHas) {
  const auto [rows, columns_a, columns_b] = GetParam();
  const Eigen::MatrixXd a = random_matrix(rows, columns_a, 3), b = random_matrix(rows, columns_b, 4);
  registers_in_use() = Registers::quarter;
  const Eigen::MatrixXd product = column_products(a, b), squares = column_products(a);
  for (const Registers registers : {Registers::half, Registers::wide}) {
    if (registers < widest_) continue;
    registers_in_use() = registers;
    EXPECT_TRUE((column_products(a, b).array() == product.array()).all());
    EXPECT_TRUE((column_products(a).array() == squares.array()).all());
  }
}

TEST_P(ColumnProducts, AreAddedToTheLowerTriangleOfAPartOfAMatrix) {
  const auto [rows, columns, unused] = GetParam();
  const Eigen::MatrixXd wide = random_matrix(rows + 3, columns + 2, 5);
  const auto part = wide.block(2, 1, rows, columns);
  Eigen::MatrixXd sum = random_matrix(columns + 4, columns + 4, 6);
  const Eigen::MatrixXd before = sum;
  add_column_products(part, sum.bottomRightCorner(columns, columns));
  const Eigen::MatrixXd expected = before.bottomRightCorner(columns, columns) + part.transpose() * part;
  for (Eigen::Index i = 0; i < columns; ++i)
    for (Eigen::Index j = 0; j <= i; ++j)
      EXPECT_NEAR(sum(i + 4, j + 4), expected(i, j), 1e-15 * (4 + static_cast<double>(rows * rows)));
  EXPECT_TRUE((sum.topRows(4).array() == before.topRows(4).array()).all());
  EXPECT_TRUE((sum.leftCols(4).array() == before.leftCols(4).array()).all());
}

/// What is zero in many rows is left out there, and every sum stays what it is alone.
TEST(ColumnProductsOfParts, AreTheSameBitByBitWithoutTheZeros) {
  constexpr Eigen::Index rows = 2500, columns = 60, parts = 5;
  Eigen::MatrixXd a = random_matrix(rows, columns, 7), b = random_matrix(rows, columns, 8);
  for (Eigen::Index c = 10; c < columns; ++c)
    for (Eigen::Index r = 0; r < rows; ++r)
      if (r * parts / rows != c % parts) a(r, c) = b(r, (c + 3) % columns) = 0;
  const Eigen::MatrixXd product = column_products(a, b), squares = column_products(a);
  for (Eigen::Index i = 0; i < columns; ++i)
    for (Eigen::Index j = 0; j < columns; ++j) {
      EXPECT_EQ(product(i, j), column_products(a.col(i), b.col(j))(0, 0)) << i << " " << j;
      EXPECT_EQ(squares(i, j), column_products(a.col(i), a.col(j))(0, 0)) << i << " " << j;
    }
  EXPECT_TRUE(column_products(Eigen::MatrixXd::Zero(100, 40)).isZero(0));
}

INSTANTIATE_TEST_SUITE_P(OfManySizes, ColumnProducts,
                         testing::Values(Product{0, 3, 2}, Product{1, 1, 1}, Product{7, 5, 3}, Product{8, 4, 4},
                                         Product{9, 9, 6}, Product{130, 7, 13}, Product{512, 6, 5},
                                         Product{1031, 17, 10}));

TEST(ColumnProductsOf, LargeMatricesAreTheSameBitByBitHoweverManyThreadsThereAre) {
  const Eigen::MatrixXd a = random_matrix(1200, 121, 7), b = random_matrix(1200, 67, 8);
  most_threads() = 1;
  const Eigen::MatrixXd product = column_products(a, b), squares = column_products(a);
  for (const int threads : {2, 3, 16}) {
    most_threads() = threads;
    EXPECT_TRUE((column_products(a, b).array() == product.array()).all());
    EXPECT_TRUE((column_products(a).array() == squares.array()).all());
  }
  most_threads() = 0;
}

TEST(ColumnProductsOf, MatricesOfAnotherHeightAreRefused) {
  EXPECT_ANY_THROW(column_products(Eigen::MatrixXd::Zero(3, 2), Eigen::MatrixXd::Zero(4, 2)));
}

}  // namespace
}  // namespace handsight
