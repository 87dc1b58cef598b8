// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Cholesky>

#include "compare/change_limits.h"
#include "compare/several_changes.h"
#include "compare/several_normal.h"

namespace handsight {

/// Normal equations of all sides, the active changes' columns behind the shared ones; with priors.
ScatteredNormal SeveralComparer::make_normal(const SeveralState& state, const std::vector<ActiveChange>& active) const {
  Eigen::Index total = sides_.columns();
  for (const ActiveChange& a : active) total += a.change.size();
  ScatteredNormal n = nothing(total);
  for (std::size_t k = 0; k < sides_.sides.size(); ++k) {
    keep_going(sides_.progress);
    std::vector<Eigen::Triplet<double>> places = shared_places(sides_, sides_.sides[k]);
    auto own = static_cast<Eigen::Index>(places.size());
    Eigen::Index all = sides_.columns();
    std::vector<EffectTerm> terms;
    for (const ActiveChange& a : active) {
      const Alternative& alternative = alternatives_[a.alternative];
      if (alternative.in[k]) {
        const ChangeUnit& unit = find_unit(k, alternative.unit);
        place_unit(places, unit, sides_.sides[k].problem.source->chain, list_sizes(alternative.unit), own, all);
        own += a.change.size();
        for (EffectTerm& t : list_terms(k, alternative.unit, a.change)) terms.push_back(std::move(t));
      }
      all += a.change.size();
    }
    const Matrix6& repeatability = sides_.repeatability[static_cast<std::size_t>(sides_.sides[k].rig)];
    add(scattered(take_rows(k, state, terms), repeatability), make_column_map(places, own, total), n);
  }
  add_priors(sides_, state, n);
  Eigen::Index column = sides_.columns();
  for (const ActiveChange& a : active)
    for (Eigen::Index i = 0; i < a.change.size(); ++i) add_prior(n, column++, a.change[i], change_scale);
  stiffen(n);
  return n;
}

/// Gauss-Newton over the shared unknowns and the changes' numbers.
SeveralComparer::Fitted SeveralComparer::fitted(std::vector<ActiveChange> active) const {
  Fitted r{state_, std::move(active), {}, 0};
  for (int i = 0; i < (sides_.is_wide ? most_change_iterations_wide : most_change_iterations); ++i) {
    const ScatteredNormal n = make_normal(r.state, r.active);
    const Eigen::VectorXd step = n.information.ldlt().solve(n.gradient);
    r.information = n.information;
    r.squares = n.squares - n.gradient.dot(step);
    r.state = moved_by(sides_, r.state, step);
    Eigen::Index column = sides_.columns();
    for (ActiveChange& a : r.active) {
      a.change += step.segment(column, a.change.size());
      column += a.change.size();
    }
    if (n.gradient.dot(step) < (sides_.is_wide ? least_change_gain_wide : least_change_gain)) break;
  }
  for (const ActiveChange& a : r.active) r.squares -= change_weight * a.change.squaredNorm();
  return r;
}

SeveralComparer::Together SeveralComparer::fitted_together(const std::vector<ActiveChange>& changes) const {
  const Fitted r = fitted(changes);
  const Eigen::VectorXd variances = last_covariance(r.information, r.information.rows() - sides_.columns()).diagonal();
  Together all{r.active, {}, r.squares};
  Eigen::Index at = 0;
  for (const ActiveChange& a : r.active) {
    all.sigmas.emplace_back(variances.segment(at, a.change.size()).cwiseMax(0).cwiseSqrt());
    at += a.change.size();
  }
  return all;
}

std::vector<double> SeveralComparer::evidence_of_each(const std::vector<ActiveChange>& changes) const {
  const Fitted all = fitted(changes);
  const Eigen::MatrixXd covariance =
      all.information.ldlt().solve(Eigen::MatrixXd::Identity(all.information.rows(), all.information.rows()));
  std::vector<double> factors;
  Eigen::Index at = sides_.columns();
  for (std::size_t i = 0; i < changes.size(); ++i) {
    std::vector<ActiveChange> others = changes;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    const Eigen::VectorXd& change = all.active[i].change;
    const Eigen::Index count = change.size();
    factors.push_back(
        evidence_at(covariance.block(at, at, count, count), change, fitted(others).squares, all.squares).evidence);
    at += count;
  }
  return factors;
}

}  // namespace handsight
