// SPDX-License-Identifier: Apache-2.0
#include "estimation/problem/column_products.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "base/error.h"
#include "base/threads.h"

namespace handsight {
namespace {

constexpr Eigen::Index lanes = 8;
constexpr Eigen::Index rows_at_once = 512;  // 4 columns of each side stay in the first cache
using Simd = double __attribute__((vector_size(lanes * sizeof(double))));

/// Columns of a block of rows.
struct Block {
  const double* first;
  Eigen::Index stride, rows;
};

struct Product {
  Block a, b;
  Eigen::Index a_columns, b_columns;
  bool is_lower;  // only tiles that reach the diagonal or lie below it
  double* sum;
  Eigen::Index sum_stride;
};

using AddBlock = void (*)(const Product&);

namespace in_quarters {
#include "estimation/problem/column_tiles.inc"
void add(const Product& p) { add_tiles<2, 1>(p); }
}  // namespace in_quarters

#if defined(__x86_64__)
#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx512f"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx512f")
#endif
namespace in_32_registers {
#include "estimation/problem/column_tiles.inc"
void add(const Product& p) { add_tiles<4, 4>(p); }
}  // namespace in_32_registers
#if defined(__clang__)
#pragma clang attribute pop
#pragma clang attribute push(__attribute__((target("avx2"))), apply_to = function)
#else
#pragma GCC pop_options
#pragma GCC push_options
#pragma GCC target("avx2")
#endif
namespace in_halves {
#include "estimation/problem/column_tiles.inc"
void add(const Product& p) { add_tiles<2, 2>(p); }
}  // namespace in_halves
#if defined(__clang__)
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif

AddBlock add_block_in(Registers registers) {
  if (registers == Registers::wide) return in_32_registers::add;
  return registers == Registers::half ? in_halves::add : in_quarters::add;
}

Registers widest() {
  if (__builtin_cpu_supports("avx512f")) return Registers::wide;
  return __builtin_cpu_supports("avx2") ? Registers::half : Registers::quarter;
}
#else
AddBlock add_block_in(Registers) { return in_quarters::add; }

Registers widest() { return Registers::quarter; }
#endif

/// Columns of a block of rows that are not zero in it: what acts in one session of several, or from one moment on, is
/// zero in the rows of the others.
std::vector<Eigen::Index> columns_that_count(const Block& block, Eigen::Index columns) {
  std::vector<Eigen::Index> counting;
  for (Eigen::Index c = 0; c < columns; ++c) {
    const double* const column = block.first + c * block.stride;
    if (std::any_of(column, column + block.rows, [](double x) { return x != 0; })) counting.push_back(c);
  }
  return counting;
}

Eigen::MatrixXd gathered(const Block& block, const std::vector<Eigen::Index>& columns) {
  Eigen::MatrixXd all(block.rows, static_cast<Eigen::Index>(columns.size()));
  for (std::size_t c = 0; c < columns.size(); ++c)
    std::copy_n(block.first + columns[c] * block.stride, block.rows, all.col(static_cast<Eigen::Index>(c)).data());
  return all;
}

/// A block's products by the columns that count alone, where these are few enough to be worth it; false where not. The
/// sums are the same bit by bit.
bool add_without_zeros(const Product& p, AddBlock add_block) {
  constexpr Eigen::Index fewest_columns = 16;
  constexpr double worth_copying = 0.75;
  if (std::min(p.a_columns, p.b_columns) < fewest_columns) return false;
  const std::vector<Eigen::Index> of_a = columns_that_count(p.a, p.a_columns),
                                  of_b = columns_that_count(p.b, p.b_columns);
  const auto a_count = static_cast<Eigen::Index>(of_a.size()), b_count = static_cast<Eigen::Index>(of_b.size());
  if (static_cast<double>(a_count * b_count) > worth_copying * static_cast<double>(p.a_columns * p.b_columns))
    return false;
  if (a_count == 0 || b_count == 0) return true;
  const Eigen::MatrixXd a = gathered(p.a, of_a), b = gathered(p.b, of_b);
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(a_count, b_count);
  add_block({{a.data(), a.outerStride(), p.a.rows},
             {b.data(), b.outerStride(), p.b.rows},
             a_count,
             b_count,
             p.is_lower,
             sum.data(),
             sum.outerStride()});
  for (Eigen::Index j = 0; j < b_count; ++j) {
    double* const to = p.sum + of_b[static_cast<std::size_t>(j)] * p.sum_stride;
    for (Eigen::Index i = p.is_lower ? j : 0; i < a_count; ++i) to[of_a[static_cast<std::size_t>(i)]] += sum(i, j);
  }
  return true;
}

void add_alone(const Columns& a, const Columns& b, bool is_lower, double* sum, Eigen::Index sum_stride) {
  const AddBlock add_block = add_block_in(registers_in_use());
  for (Eigen::Index r = 0; r < a.rows(); r += rows_at_once) {
    const Eigen::Index rows = std::min(rows_at_once, a.rows() - r);
    const Product product{{a.data() + r, a.outerStride(), rows},
                          {b.data() + r, b.outerStride(), rows},
                          a.cols(),
                          b.cols(),
                          is_lower,
                          sum,
                          sum_stride};
    if (!add_without_zeros(product, add_block)) add_block(product);
  }
}

/// Where part `part` of the columns of b begins: each has about as many products.
Eigen::Index first_column(Eigen::Index columns, int part, int parts, bool is_lower) {
  const double share = static_cast<double>(part) / parts;
  const double at = is_lower ? 1 - std::sqrt(1 - share) : share;
  return part == parts ? columns : static_cast<Eigen::Index>(at * static_cast<double>(columns));
}

/// Large products in parts, some columns of b each: every sum is made as it would be alone.
void add(const Columns& a, const Columns& b, bool is_lower, double* sum, Eigen::Index sum_stride) {
  constexpr double worth_threads = 4e6;  // products
  check(a.rows() == b.rows(), "{} and {} rows", a.rows(), b.rows());
  const bool is_large = static_cast<double>(a.rows()) * static_cast<double>(a.cols() * b.cols()) > worth_threads;
  const int parts = is_large ? 2 * threads_for(static_cast<int>(b.cols())) : 1;
  each_part(parts, parts > 2, [&](int part) {
    const Eigen::Index first = first_column(b.cols(), part, parts, is_lower);
    const Eigen::Index count = first_column(b.cols(), part + 1, parts, is_lower) - first, above = is_lower ? first : 0;
    add_alone(a.rightCols(a.cols() - above), b.middleCols(first, count), is_lower, sum + above + first * sum_stride,
              sum_stride);
  });
}

}  // namespace

Registers& registers_in_use() {
  static Registers registers = widest();
  return registers;
}

Eigen::MatrixXd column_products(const Columns& a, const Columns& b) {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(a.cols(), b.cols());
  add(a, b, false, sum.data(), sum.outerStride());
  return sum;
}

Eigen::MatrixXd column_products(const Columns& a) {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(a.cols(), a.cols());
  add_column_products(a, sum);
  sum.triangularView<Eigen::StrictlyUpper>() = sum.transpose();
  return sum;
}

void add_column_products(const Columns& a, Eigen::Ref<Eigen::MatrixXd> sum) {
  check(sum.rows() == a.cols() && sum.cols() == a.cols(), "{} columns for a sum of {} x {}", a.cols(), sum.rows(),
        sum.cols());
  add(a, a, true, sum.data(), sum.outerStride());
}

}  // namespace handsight
