// SPDX-License-Identifier: Apache-2.0
// The normal equations of several sessions and of what changed between them. Internal to several_*.cpp.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "compare/change_candidates.h"
#include "compare/several_sides.h"

namespace handsight {

/// Numbers of a unit that are no choices.
Eigen::Index list_numbers(const ChangeUnit& unit);

ScatteredNormal nothing(Eigen::Index columns);

/// A side's columns by those of all.
using ColumnMap = Eigen::SparseMatrix<double>;
ColumnMap make_column_map(const std::vector<Eigen::Triplet<double>>& places, Eigen::Index own, Eigen::Index all);

void add(const ScatteredNormal& own, const ColumnMap& map, ScatteredNormal& all);

/// So that what nothing tells has an answer.
void stiffen(ScatteredNormal& n);

/// A change at `value` that is held at `scale` prior sigmas.
void add_prior(ScatteredNormal& n, Eigen::Index column, double value, double scale);

/// Where a unit's numbers of one side go: as large there as in the unit's own sizes.
void place_unit(std::vector<Eigen::Triplet<double>>& places, const ChangeUnit& unit, const Chain& chain,
                const Eigen::VectorXd& sizes, Eigen::Index own, Eigen::Index all);

std::vector<Eigen::Triplet<double>> shared_places(const SeveralSides& sides, const SeveralSide& side);

struct EvidenceAt {
  double evidence = 0, gained = 0;
};

/// Of a change that was fitted with this answer and covariance, by the squares with and without it. It was held at
/// change_scale; the prior of each scale is counted in the evidence.
EvidenceAt evidence_at(const Eigen::MatrixXd& covariance, const Eigen::VectorXd& change, double squares_without,
                       double squares_with);

}  // namespace handsight
