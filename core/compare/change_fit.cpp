// SPDX-License-Identifier: Apache-2.0
#include "compare/change_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <map>

#include "compare/change_evidence.h"
#include "compare/change_limits.h"
#include "diagnosis/evidence/candidates.h"
#include "diagnosis/evidence/evidence.h"

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
    double ln_bayes_factor = 0, explained = 0, visible = 0;
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
    Candidates c = list_candidates(with_held, terms);
    Eigen::VectorXd values(c.problem.effect_count());
    values.head(base_effects_) = u.effects.head(base_effects_);
    Eigen::Index next = base_effects_;
    for (const EffectTerm& t : terms)
      for (std::size_t p = 0; p < t.values.size(); ++p)
        if (!term_effect(t).parameters[p].is_choice) values[next++] = t.values[p];
    set_effects(c.problem, values);
    return std::move(c.problem);
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
      r.terms = with_change(r.terms, r.change);
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

  std::vector<EffectTerm> with_change(std::vector<EffectTerm> terms, const Eigen::VectorXd& change) const {
    Eigen::Index c = 0;
    for (EffectTerm& t : terms)
      for (std::size_t p = 0; p < t.values.size(); ++p)
        if (!term_effect(t).parameters[p].is_choice) t.values[p] = change[c] * sizes_[c], ++c;
    return terms;
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
    const ScatteredNormal n = with_priors(free_change_scale);
    const Eigen::Index base = shared_columns(sides_), changes = n.gradient.size() - base;
    const Eigen::LDLT<Eigen::MatrixXd> shared(n.information.topLeftCorner(base, base));
    const Eigen::MatrixXd cross = n.information.topRightCorner(base, changes);
    const Eigen::MatrixXd information =
        n.information.bottomRightCorner(changes, changes) - cross.transpose() * shared.solve(cross);
    const Eigen::VectorXd gradient = n.gradient.tail(changes) - cross.transpose() * shared.solve(n.gradient.head(base));
    found_.assign(units_.size(), {});
    std::vector<std::size_t> order;
    std::vector<ChangePlace> places;
    Eigen::Index at = 0;
    for (std::size_t u = 0; u < units_.size(); ++u) {
      Eigen::Index count = 0;
      for (const EffectTerm& t : units_[u].terms)
        for (const EffectParameter& p : term_effect(t).parameters) count += !p.is_choice;
      const Eigen::MatrixXd a = information.block(at, at, count, count);
      Found& f = found_[u];
      f.visible = a.trace();
      f.terms = units_[u].terms;
      f.sigma = Eigen::VectorXd::Zero(count);
      if (f.visible >= least_visible_change) {
        f.ln_bayes_factor = change_evidence(a, gradient.segment(at, count));
        order.push_back(u);
        places.push_back({units_[u].group, at, count});
      }
      at += count;
    }
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return found_[a].ln_bayes_factor > found_[b].ln_bayes_factor;
    });
    threshold_ = change_threshold(information, places);
    if (is_wide()) keep_best_of_groups(order);
    if (order.size() > most_refitted) order.resize(most_refitted);
    std::erase_if(order, [&](std::size_t u) { return found_[u].ln_bayes_factor < 0.3 * threshold_; });
    return order;
  }

  /// One of the best units fitted in full; the Bayes factor then by Laplace's approximation at its answer.
  void refit(std::size_t u) {
    const Refitted r = fitted(units_[u].terms);
    const Eigen::Index base = shared_columns(sides_), count = r.change.size();
    Eigen::MatrixXd ends = Eigen::MatrixXd::Zero(base + count, count);
    ends.bottomRows(count).setIdentity();
    const Eigen::MatrixXd covariance = r.information.ldlt().solve(ends).bottomRows(count);
    // Held while it was fitted; the prior of each scale is counted in the evidence.
    const double gained = none_squares_ - (r.squares - change_weight * r.change.squaredNorm());
    const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(count, count);
    const double evidence = change_evidence_at(covariance.ldlt().solve(one) - change_weight * one, r.change, gained);
    if (!std::isfinite(evidence) || !covariance.allFinite()) return;  // the linearised answer stands
    Found& f = found_[u];
    f.ln_bayes_factor = evidence;
    f.explained = gained;
    f.terms = r.terms;
    f.sigma = covariance.diagonal().cwiseMax(0).cwiseSqrt().cwiseProduct(sizes_);
  }

  std::vector<Change> grouped() const {
    std::map<std::string, std::vector<double>> factors;
    std::map<std::string, std::size_t> best;
    for (std::size_t u = 0; u < units_.size(); ++u) {
      if (found_[u].visible < least_visible_change) continue;
      factors[units_[u].group].push_back(found_[u].ln_bayes_factor);
      const auto [place, is_new] = best.emplace(units_[u].group, u);
      if (!is_new && found_[u].ln_bayes_factor > found_[place->second].ln_bayes_factor) place->second = u;
    }
    std::vector<Change> changes;
    for (const auto& [group, u] : best) {
      Change c{group,
               {},
               found_[u].terms,
               found_[u].sigma,
               list_number_units(found_[u].terms, after_.problem.source->chain.robot),
               ln_mean_exp(factors[group]),
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
  std::vector<Found> found_;
  double none_squares_ = 0, threshold_ = 0;
};

}  // namespace

RankedChanges ranked_changes(const ComparedSides& sides, const std::vector<EffectTerm>& held) {
  return Comparer(sides, held).rank();
}

}  // namespace handsight
