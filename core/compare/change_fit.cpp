// SPDX-License-Identifier: Apache-2.0
#include "compare/change_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "compare/change_candidates.h"
#include "compare/change_limits.h"
#include "compare/change_normal.h"

namespace handsight {
namespace {

constexpr std::size_t most_refitted = 8, most_groups_wide = 5;

/// The shared unknowns and how one change of the second side is added to them.
class Comparer {
 public:
  Comparer(const ComparedSides& sides, const std::vector<EffectTerm>& held)
      : sides_(sides), after_(sides_.after), held_(held), state_(make_start(sides)) {
    units_ = change_units(after_.problem);
    base_effects_ = after_.problem.effect_count();
  }

  RankedChanges rank() {
    fit_nothing();
    const std::vector<std::size_t> best = rank_linearly();
    if (held_.empty() || !is_wide())
      for (const std::size_t u : best) refit(u);
    return {grouped(), threshold_, left_, sides_};
  }

 private:
  /// One unit of the second side with what was found of it.
  struct Found {
    std::vector<EffectTerm> terms;
    Eigen::VectorXd sigma;
    double explained = 0;
  };

  bool is_wide() const { return sides_.reported_effects >= 0; }  // hundreds of columns

  struct Refitted {
    SharedState state;
    std::vector<EffectTerm> terms;
    Eigen::VectorXd change;  // in prior sigmas
    Eigen::MatrixXd information;
    double squares = 0;
  };

  /// The second side's problem with these terms as its changes, standing at values of the base's effects and theirs.
  Problem changed(const std::vector<EffectTerm>& terms, const Unknowns& u) const {
    Problem with_held = after_.problem;
    for (const EffectTerm& t : held_) with_held.terms.push_back(t);
    return with_changes(with_held, terms, u.effects.head(base_effects_));
  }

  /// Rows of both sides with these changes' columns behind the shared ones.
  ChangeRows rows_with(const std::vector<EffectTerm>& terms, const SharedState& state) {
    const Problem problem = changed(terms, state.unknowns);
    const ChangeColumns columns{base_effects_, &sides_.curves, column_count(sides_.curves),
                                problem.effect_count() - base_effects_};
    SharedState here = state;
    here.unknowns.effects = effect_values(problem);
    sizes_.resize(columns.changes);
    for (Eigen::Index c = 0; c < sizes_.size(); ++c)
      sizes_[c] = problem.columns_of_effects[static_cast<std::size_t>(base_effects_ + c)].sigma;
    ChangeRows rows = change_rows(problem, here, columns, after_.weight);
    if (sides_.before) {
      Problem& first = sides_.before->problem;
      if (base_effects_ > 0) set_effects(first, state.unknowns.effects.head(base_effects_));
      here.unknowns.effects = effect_values(first);
      rows.add(change_rows(first, here, columns, sides_.before->weight));
    }
    return sides_.known ? with_rigid_markers(rows, state.unknowns.markers_in_tcp) : rows;
  }

  /// Gauss-Newton over the shared unknowns and one unit's numbers.
  Refitted fitted(std::vector<EffectTerm> terms) {
    Refitted r{state_, std::move(terms), {}, {}, 0};
    for (int i = 0; i < (is_wide() ? most_change_iterations_wide : most_change_iterations); ++i) {
      keep_going(sides_.progress);
      const ChangeRows rows = rows_with(r.terms, r.state);
      if (r.change.size() != sizes_.size()) r.change = find_change(r.terms);
      ScatteredNormal n = scattered(rows, sides_.repeatability);
      add_priors(sides_, r.state, r.change, change_scale, n);
      const Eigen::VectorXd step = n.information.ldlt().solve(n.gradient);
      r.information = n.information;
      r.squares = n.squares - n.gradient.dot(step);
      const Eigen::Index base = shared_columns(sides_);
      r.state = moved_by(sides_, r.state, step.head(base));
      r.change += step.tail(step.size() - base);
      r.terms = with_numbers(std::move(r.terms), r.change.cwiseProduct(sizes_));
      if (n.gradient.dot(step) < (is_wide() ? least_change_gain_wide : least_change_gain)) break;
    }
    return r;
  }

  Eigen::VectorXd find_change(const std::vector<EffectTerm>& terms) const {
    Eigen::VectorXd change(sizes_.size());
    Eigen::Index c = 0;
    for (const EffectTerm& t : terms)
      for (std::size_t p = 0; p < t.values.size(); ++p)
        if (!term_effect(t).parameters[p].is_choice) change[c] = t.values[p] / sizes_[c], ++c;
    return change;
  }

  /// Normal equations of the linearised model with all changes, and priors.
  ScatteredNormal with_priors(double scale_of_changes) const {
    ScatteredNormal n = scattered(linear_, sides_.repeatability);
    add_priors(sides_, state_, Eigen::VectorXd::Zero(n.gradient.size() - shared_columns(sides_)), scale_of_changes, n);
    return n;
  }

  void linearise() { linear_ = rows_with(all_terms_, state_); }

  /// The shared unknowns alone; then what all changes together do not explain: sizes of what both sides lack, and
  /// scatter. A wide model stays where it started: with what has changed still missing it would go astray.
  void fit_nothing() {
    for (const ChangeUnit& unit : units_) all_terms_.insert(all_terms_.end(), unit.terms.begin(), unit.terms.end());
    if (!is_wide()) state_ = fitted({}).state;
    linearise();
    if (!sides_.known && held_.empty())  // what a calibration says of the scatter stays
      for (int round = 0; round < (is_wide() ? learning_rounds : 1); ++round) learn();
    const Refitted none = fitted({});
    none_squares_ = none.squares;
    if (!is_wide()) state_ = none.state;
    linearise();
  }

  void learn() {
    if (is_wide())
      for (int i = 0; i < learning_steps; ++i) learn_sizes(sides_, state_, with_priors(change_scale));
    sides_.repeatability.setZero();
    const ScatteredNormal n = with_priors(change_scale);
    const Eigen::VectorXd step = n.information.ldlt().solve(n.gradient);
    left_ = left_over(linear_, step, settled_parameters(n, linear_.information),
                      (sides_.before ? sides_.before->noise_degrees : 0) + after_.noise_degrees);
    sides_.repeatability = left_.repeatability;
  }

  /// The first unit of each of the best groups.
  void keep_best_of_groups(std::vector<std::size_t>& order) const {
    std::vector<std::string> groups;
    std::erase_if(order, [&](std::size_t u) {
      if (std::find(groups.begin(), groups.end(), units_[u].group) != groups.end()) return true;
      groups.push_back(units_[u].group);
      return false;
    });
    if (order.size() > most_groups_wide) order.resize(most_groups_wide);
  }

  /// Of every unit by the linearised model; those worth a fit of their own, best first.
  std::vector<std::size_t> rank_linearly() {
    found_.clear();
    findings_.clear();
    for (const ChangeUnit& unit : units_) {
      findings_.push_back({unit.group, count_numbers(unit.terms)});
      found_.push_back({unit.terms, Eigen::VectorXd::Zero(findings_.back().numbers)});
    }
    LinearRanking ranking = handsight::rank_linearly(with_priors(free_change_scale), findings_);
    threshold_ = ranking.threshold;
    std::vector<std::size_t> order = std::move(ranking.order);
    if (is_wide()) keep_best_of_groups(order);
    if (order.size() > most_refitted) order.resize(most_refitted);
    std::erase_if(order, [&](std::size_t u) { return findings_[u].ln_bayes_factor < 0.3 * threshold_; });
    return order;
  }

  /// One of the best units fitted in full; the Bayes factor then by Laplace's approximation at its answer.
  void refit(std::size_t u) {
    const Refitted r = fitted(units_[u].terms);
    const Eigen::MatrixXd covariance = last_covariance(r.information, r.change.size());
    const auto [evidence, gained] =
        evidence_at(covariance, r.change, none_squares_, r.squares - change_weight * r.change.squaredNorm());
    if (!std::isfinite(evidence) || !covariance.allFinite()) return;  // the linearised answer stands
    findings_[u].ln_bayes_factor = evidence;
    Found& f = found_[u];
    f.explained = gained;
    f.terms = r.terms;
    f.sigma = covariance.diagonal().cwiseMax(0).cwiseSqrt().cwiseProduct(sizes_);
  }

  std::vector<Change> grouped() const {
    std::vector<Change> changes;
    for (const auto& [group, evidence] : group_evidence(findings_)) {
      const std::size_t u = evidence.best;
      Change c{group,
               {},
               found_[u].terms,
               found_[u].sigma,
               list_number_units(found_[u].terms, after_.problem.source->chain.robot),
               evidence.ln_bayes_factor,
               found_[u].explained};
      if (!units_[u].where.empty()) c.where = {units_[u].where};
      changes.push_back(std::move(c));
    }
    const auto weight = [](const Change& c) { return c.ln_bayes_factor + ln_prior_odds(c.id); };
    std::stable_sort(changes.begin(), changes.end(),
                     [&](const Change& a, const Change& b) { return weight(a) > weight(b); });
    return changes;
  }

  ComparedSides sides_;
  const ComparedSide& after_;  // of sides_
  std::vector<EffectTerm> held_, all_terms_;
  SharedState state_;
  std::vector<ChangeUnit> units_;
  Eigen::Index base_effects_ = 0;
  Eigen::VectorXd sizes_;  // plausible, of the changes' columns of the last rows
  ChangeRows linear_;
  LeftOver left_;
  std::vector<Found> found_;             // by unit
  std::vector<ChangeFinding> findings_;  // the same
  double none_squares_ = 0, threshold_ = 0;
};

}  // namespace

RankedChanges ranked_changes(const ComparedSides& sides, const std::vector<EffectTerm>& held) {
  return Comparer(sides, held).rank();
}

}  // namespace handsight
