// SPDX-License-Identifier: Apache-2.0
#include "compare/several_normal.h"

namespace handsight {

ScatteredNormal nothing(Eigen::Index columns) {
  return {Eigen::MatrixXd::Zero(columns, columns), Eigen::VectorXd::Zero(columns), 0};
}

ColumnMap make_column_map(const std::vector<Eigen::Triplet<double>>& places, Eigen::Index own, Eigen::Index all) {
  ColumnMap map(own, all);
  map.setFromTriplets(places.begin(), places.end());
  return map;
}

void add(const ScatteredNormal& own, const ColumnMap& map, ScatteredNormal& all) {
  const Eigen::MatrixXd half = own.information * map;
  all.information += map.transpose() * half;
  all.gradient += map.transpose() * own.gradient;
  all.squares += own.squares;
}

void place_unit(std::vector<Eigen::Triplet<double>>& places, const ChangeUnit& unit, const Chain& chain,
                const Eigen::VectorXd& sizes, Eigen::Index own, Eigen::Index all) {
  Eigen::Index i = 0;
  for (const EffectTerm& t : unit.terms)
    for (const EffectParameter& p : term_effect(t).parameters) {
      if (p.is_choice) continue;
      places.emplace_back(own + i, all + i, sizes[i] / prior_sigma(p, chain));
      ++i;
    }
}

std::vector<Eigen::Triplet<double>> shared_places(const SeveralSides& sides, const SeveralSide& side) {
  std::vector<Eigen::Triplet<double>> places;
  for (const ColumnPlace& c : list_columns(sides, side))
    places.emplace_back(static_cast<Eigen::Index>(places.size()), c.column, c.times);
  return places;
}

}  // namespace handsight
