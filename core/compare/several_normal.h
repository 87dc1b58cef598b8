// SPDX-License-Identifier: Apache-2.0
// Where the columns of one of several sessions go among those of all. Internal to several_*.cpp.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "compare/change_candidates.h"
#include "compare/several_sides.h"

namespace handsight {

ScatteredNormal nothing(Eigen::Index columns);

/// A side's columns by those of all.
using ColumnMap = Eigen::SparseMatrix<double>;
ColumnMap make_column_map(const std::vector<Eigen::Triplet<double>>& places, Eigen::Index own, Eigen::Index all);

void add(const ScatteredNormal& own, const ColumnMap& map, ScatteredNormal& all);

/// Where a unit's numbers of one side go: as large there as in the unit's own sizes.
void place_unit(std::vector<Eigen::Triplet<double>>& places, const ChangeUnit& unit, const Chain& chain,
                const Eigen::VectorXd& sizes, Eigen::Index own, Eigen::Index all);

std::vector<Eigen::Triplet<double>> shared_places(const SeveralSides& sides, const SeveralSide& side);

}  // namespace handsight
