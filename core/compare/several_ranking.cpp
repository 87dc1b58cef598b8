// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "compare/change_limits.h"
#include "compare/several_changes.h"
#include "compare/several_normal.h"
#include "estimation/fit/noise.h"

namespace handsight {
namespace {

constexpr std::size_t most_groups = 5, most_beside = 3;  // that are fitted in full: the best of each, the best of all

int sides_in(const Alternative& a) { return static_cast<int>(std::count(a.in.begin(), a.in.end(), 1)); }

}  // namespace

/// Rows of every side with all of its units, where those that were taken stand at their numbers.
void SeveralComparer::linearise(const std::vector<ActiveChange>& taken) {
  linear_.clear();
  for (std::size_t k = 0; k < sides_.sides.size(); ++k) {
    keep_going(sides_.progress);
    std::vector<EffectTerm> terms;
    for (std::size_t own = 0; own < of_sides_[k].size(); ++own) {
      const std::size_t first = terms.size();
      terms.insert(terms.end(), of_sides_[k][own].terms.begin(), of_sides_[k][own].terms.end());
      for (const ActiveChange& a : taken) {
        const Alternative& alternative = alternatives_[a.alternative];
        if (!alternative.in[k] || units_[alternative.unit].at[k] != static_cast<int>(own)) continue;
        const std::vector<EffectTerm> here = list_terms(k, alternative.unit, a.change);
        for (std::size_t t = 0; t < here.size(); ++t)
          for (std::size_t p = 0; p < here[t].values.size(); ++p)
            if (!term_effect(here[t]).parameters[p].is_choice) terms[first + t].values[p] += here[t].values[p];
      }
    }
    linear_.push_back(take_rows(k, state_, terms));
  }
}

struct SeveralComparer::Linear {
  std::vector<ColumnMap> maps;  // by side
  ScatteredNormal normal;       // without priors
};

/// The linearised model with these changes' columns behind the shared ones.
SeveralComparer::Linear SeveralComparer::make_linear(const std::vector<ActiveChange>& columns,
                                                     bool with_repeatability) const {
  Eigen::Index total = sides_.columns();
  for (const ActiveChange& a : columns) total += a.change.size();
  Linear linear{{}, nothing(total)};
  for (std::size_t k = 0; k < sides_.sides.size(); ++k) {
    const SeveralSide& side = sides_.sides[k];
    std::vector<Eigen::Triplet<double>> places = shared_places(sides_, side);
    std::vector<Eigen::Index> first{static_cast<Eigen::Index>(places.size())};  // column of each of its units
    for (const ChangeUnit& unit : of_sides_[k]) first.push_back(first.back() + handsight::count_numbers(unit.terms));
    Eigen::Index all = sides_.columns();
    for (const ActiveChange& a : columns) {
      const Alternative& alternative = alternatives_[a.alternative];
      if (alternative.in[k])
        place_unit(places, find_unit(k, alternative.unit), side.problem.source->chain, list_sizes(alternative.unit),
                   first[static_cast<std::size_t>(units_[alternative.unit].at[k])], all);
      all += a.change.size();
    }
    linear.maps.push_back(make_column_map(places, linear_[k].gradient.size(), total));
    const Matrix6 repeatability =
        with_repeatability ? sides_.repeatability[static_cast<std::size_t>(side.rig)] : Matrix6::Zero();
    add(scattered(linear_[k], repeatability), linear.maps.back(), linear.normal);
  }
  return linear;
}

/// Adds priors: of what is shared, of the first changes at their numbers, of those after them at `scale_of_free`.
ScatteredNormal SeveralComparer::with_priors(ScatteredNormal n, const std::vector<ActiveChange>& columns,
                                             std::size_t taken, double scale_of_free) const {
  add_priors(sides_, state_, n);
  Eigen::Index column = sides_.columns();
  for (std::size_t a = 0; a < columns.size(); ++a)
    for (Eigen::Index i = 0; i < columns[a].change.size(); ++i)
      add_prior(n, column++, columns[a].change[i], a < taken ? change_scale : scale_of_free);
  stiffen(n);
  return n;
}

/// Each session against the first of those that have a unit in common: all changes that there can be.
std::vector<ActiveChange> SeveralComparer::all_changes() const {
  std::vector<ActiveChange> all;
  for (std::size_t a = 0; a < alternatives_.size(); ++a)
    if (sides_in(alternatives_[a]) == 1)
      all.push_back({a, Eigen::VectorXd::Zero(count_numbers(alternatives_[a].unit))});
  return all;
}

/// Sizes of what the model lacks, and the scatter, from what all changes together leave.
void SeveralComparer::learn(SeveralRanking& ranking) {
  const std::vector<ActiveChange> all = all_changes();
  for (int i = 0; sides_.is_wide && i < learning_steps; ++i) {
    keep_going(sides_.progress);
    learn_sizes(sides_, state_, with_priors(make_linear(all, true).normal, all, 0, change_scale));
  }
  const Linear linear = make_linear(all, false);
  const ScatteredNormal n = with_priors(linear.normal, all, 0, change_scale);
  const Eigen::VectorXd step = n.information.ldlt().solve(n.gradient);
  set_repeatability(linear, step, settled_parameters(n, linear.normal.information), ranking);
}

/// What a step leaves beside the noise; where that is more than noise, it is motions of the body, of each rig's own
/// covariance.
void SeveralComparer::set_repeatability(const Linear& linear, const Eigen::VectorXd& step, double settled,
                                        SeveralRanking& ranking) {
  std::vector<BodyErrors> left(sides_.repeatability.size());
  double rows = 0, noise_degrees = 0;
  for (std::size_t k = 0; k < sides_.sides.size(); ++k) {
    const Eigen::VectorXd own = linear.maps[k] * step;
    for (const ChangeObservation& o : linear_[k].observations) {
      BodyErrors& of_rig = left[static_cast<std::size_t>(sides_.sides[k].rig)];
      of_rig.errors.emplace_back(o.body_by_error - o.body_by_columns * own);
      of_rig.body_squares.push_back(o.body_squares);
    }
    rows += linear_[k].rows;
    noise_degrees += sides_.sides[k].noise_degrees;
  }
  const ScatteredNormal& n = linear.normal;
  const double squares = n.squares - 2 * n.gradient.dot(step) + step.dot(n.information * step);
  ranking.left = {};
  if (const auto test = noise_test(squares, rows - settled, noise_degrees)) ranking.left.p = test->p;
  for (std::size_t r = 0; r < left.size(); ++r)
    sides_.repeatability[r] = ranking.left.p > more_than_noise ? Matrix6(Matrix6::Zero()) : repeatability_of(left[r]);
}

/// Of every alternative by the linearised model; those worth a fit of their own, best first.
std::vector<std::size_t> SeveralComparer::rank_linearly(const std::vector<ActiveChange>& taken,
                                                        SeveralRanking& ranking) {
  std::vector<ActiveChange> columns = taken;
  std::vector<ChangeFinding> free;
  for (std::size_t a = 0; a < alternatives_.size(); ++a) {
    if (std::any_of(taken.begin(), taken.end(), [&](const ActiveChange& t) { return t.alternative == a; })) continue;
    columns.push_back({a, Eigen::VectorXd::Zero(ranking.found[a].numbers)});
    free.push_back(ranking.found[a]);
  }
  const LinearRanking linear = handsight::rank_linearly(
      with_priors(make_linear(columns, true).normal, columns, taken.size(), free_change_scale), free);
  const auto alternative = [&](std::size_t i) { return columns[taken.size() + i].alternative; };
  for (std::size_t i = 0; i < free.size(); ++i) static_cast<ChangeFinding&>(ranking.found[alternative(i)]) = free[i];
  ranking.threshold = linear.threshold;
  std::vector<std::size_t> order;
  for (const std::size_t i : linear.order) order.push_back(alternative(i));
  return worth_a_fit(order, ranking);
}

/// The best of the best groups, and the best of all.
std::vector<std::size_t> SeveralComparer::worth_a_fit(const std::vector<std::size_t>& order,
                                                      const SeveralRanking& ranking) const {
  std::vector<std::size_t> chosen;
  std::vector<std::string> groups;
  std::size_t beside = 0;
  for (const std::size_t a : order) {
    if (ranking.found[a].ln_bayes_factor < 0.3 * ranking.threshold) break;
    const std::string& group = units_[alternatives_[a].unit].group;
    const bool is_first = std::find(groups.begin(), groups.end(), group) == groups.end();
    if (is_first ? groups.size() == most_groups : beside++ >= most_beside) continue;
    if (is_first) groups.push_back(group);
    chosen.push_back(a);
  }
  return chosen;
}

/// One alternative fitted in full beside those that are taken; the Bayes factor then by Laplace's approximation.
void SeveralComparer::refit(std::size_t alternative, const std::vector<ActiveChange>& taken, double squares_without,
                            SeveralRanking& ranking) const {
  std::vector<ActiveChange> active = taken;
  active.push_back({alternative, Eigen::VectorXd::Zero(count_numbers(alternatives_[alternative].unit))});
  const Fitted r = fitted(std::move(active));
  const Eigen::VectorXd& change = r.active.back().change;
  const Eigen::MatrixXd covariance = last_covariance(r.information, change.size());
  const auto [evidence, gained] = evidence_at(covariance, change, squares_without, r.squares);
  if (!std::isfinite(evidence) || !covariance.allFinite()) return;  // the linearised answer stands
  FoundChange& f = ranking.found[alternative];
  f.ln_bayes_factor = evidence;
  f.explained = gained;
  f.change = change;
  f.sigma = covariance.diagonal().cwiseMax(0).cwiseSqrt();
}

SeveralRanking SeveralComparer::rank(const std::vector<ActiveChange>& taken, bool learns) {
  SeveralRanking ranking;
  for (const Alternative& a : alternatives_)
    ranking.found.push_back({{units_[a.unit].group, count_numbers(a.unit)}, {}, {}});
  if (learns) {
    if (!sides_.is_wide) state_ = fitted({}).state;
    linearise({});
    for (int round = 0; round < (sides_.is_wide ? learning_rounds : 1); ++round) learn(ranking);
  }
  const Fitted without = fitted(taken);
  // A wide model stays where it started: with what has changed still missing it would go astray.
  if (!sides_.is_wide) state_ = without.state;
  linearise(without.active);
  for (const std::size_t a : rank_linearly(without.active, ranking)) refit(a, without.active, without.squares, ranking);
  ranking.groups = group_evidence({ranking.found.begin(), ranking.found.end()});
  return ranking;
}

}  // namespace handsight
