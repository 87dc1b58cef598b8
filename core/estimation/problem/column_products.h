// SPDX-License-Identifier: Apache-2.0
// Products of the columns of tall matrices, as normal equations and evidence are made of: in 8 lanes where the
// processor has AVX-512, in as many halves where it has less; results are the same bit by bit.
#pragma once

#include <Eigen/Core>
#include <algorithm>

namespace handsight {

/// Of how many doubles the processor's registers are, and how many of them there are: 8 in 32, 4 in 16, 2 in 16.
enum class Registers { wide, half, quarter };

/// Those in use: the widest there are. Tests set it to compare.
Registers& registers_in_use();

/// Columns one after another, as Eigen's own matrices and their blocks have them.
using Columns = Eigen::Ref<const Eigen::MatrixXd>;

/// a^T b; both have as many rows.
Eigen::MatrixXd column_products(const Columns& a, const Columns& b);

/// a^T a, whole.
Eigen::MatrixXd column_products(const Columns& a);

/// Adds a^T a to the lower triangle of `sum`; above it nothing is to be relied on.
void add_column_products(const Columns& a, Eigen::Ref<Eigen::MatrixXd> sum);

/// Adds r^T r of row after row to the lower triangle of a sum, many rows at a time: one long product costs less than
/// many short ones. The sum must outlive it, and is complete once the rows are settled.
class GatheredRows {
 public:
  /// `expected`: how many rows come in all, where they are few.
  explicit GatheredRows(Eigen::Ref<Eigen::MatrixXd> sum, Eigen::Index expected = most)
      : sum_(sum), rows_(std::min(expected, most), sum.cols()) {}

  template <class Rows>
  void add(const Rows& rows) {
    if (used_ + rows.rows() > rows_.rows()) settle();
    if (rows.rows() > rows_.rows()) rows_.resize(rows.rows(), Eigen::NoChange);
    rows_.middleRows(used_, rows.rows()).noalias() = rows;
    used_ += rows.rows();
  }

  void settle() {
    add_column_products(rows_.topRows(used_), sum_);
    used_ = 0;
  }

 private:
  static constexpr Eigen::Index most = 256;
  Eigen::Ref<Eigen::MatrixXd> sum_;
  Eigen::MatrixXd rows_;
  Eigen::Index used_ = 0;
};

}  // namespace handsight
