// SPDX-License-Identifier: Apache-2.0
// Products of the columns of tall matrices, as normal equations and evidence are made of: in 8 lanes where the
// processor has AVX-512, in as many halves where it has less; results are the same bit by bit.
#pragma once

#include <Eigen/Core>

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

}  // namespace handsight
