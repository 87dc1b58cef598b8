// SPDX-License-Identifier: Apache-2.0
#include "compare/several_normal.h"

#include <Eigen/Cholesky>

#include "compare/change_evidence.h"
#include "compare/change_limits.h"
#include "diagnosis/evidence/candidates.h"

namespace handsight {

Eigen::Index list_numbers(const ChangeUnit& unit) {
  Eigen::Index count = 0;
  for (const EffectTerm& t : unit.terms)
    for (const EffectParameter& p : term_effect(t).parameters) count += !p.is_choice;
  return count;
}

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

void stiffen(ScatteredNormal& n) {
  for (Eigen::Index i = 0; i < n.gradient.size(); ++i) n.information(i, i) += 1e-12 * n.information(i, i) + 1e-12;
}

void add_prior(ScatteredNormal& n, Eigen::Index column, double value, double scale) {
  n.information(column, column) += 1 / (scale * scale);
  n.gradient[column] -= value / (scale * scale);
  n.squares += value * value / (scale * scale);
}

EvidenceAt evidence_at(const Eigen::MatrixXd& covariance, const Eigen::VectorXd& change, double squares_without,
                       double squares_with) {
  const double gained = squares_without - squares_with;
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(change.size(), change.size());
  return {change_evidence_at(covariance.ldlt().solve(one) - change_weight * one, change, gained), gained};
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
