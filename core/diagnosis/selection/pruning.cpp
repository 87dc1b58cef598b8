// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/selection/pruning.h"

#include <algorithm>
#include <set>

#include "base/threads.h"
#include "diagnosis/evidence/prior_odds.h"
#include "diagnosis/ranking/curves.h"
#include "diagnosis/ranking/refitting.h"
#include "diagnosis/selection/begin_of_names.h"
#include "diagnosis/selection/diagnosed_model.h"
#include "diagnosis/selection/elsewhere.h"
#include "diagnosis/selection/exchange.h"
#include "diagnosis/selection/taken_over.h"
#include "diagnosis/verdict/diagnosis.h"
#include "estimation/solvers/inverse_parts.h"

namespace handsight {
namespace {

constexpr int most_groups_each_time = 4;  // exchanges are looked for after every addition up to here
constexpr double clearly_better = 2;      // ln: for another form of a curve

/// What the squares would grow by, in units of the noise and to first order, if the terms from `first` to `last` of
/// the estimated ones were 0 and all else followed.
double squares_without(const Fit& fit, const FitOptions& options, std::size_t first, std::size_t last, double noise) {
  const Problem& problem = fit.problem;
  const std::size_t held = options.effects.size();
  std::vector<Eigen::Index> theirs, others;
  for (Eigen::Index c = 0; c < problem.columns(); ++c) {
    const Eigen::Index effect = c - problem.effect_column();
    const std::size_t term = effect < 0 ? 0 : problem.columns_of_effects[static_cast<std::size_t>(effect)].term - held;
    (effect >= 0 && term >= first && term < last ? theirs : others).push_back(c);
  }
  const Eigen::MatrixXd& h = fit.solution.normal.information;
  Eigen::VectorXd all = Eigen::VectorXd::Zero(problem.columns());
  all.tail(problem.effect_count()) = estimate(fit).effects;
  const Eigen::VectorXd value = all(theirs);
  const Eigen::VectorXd shared = h(others, theirs) * value;
  const double squares = value.dot(h(theirs, theirs) * value) - shared.dot(pseudo_inverse(h(others, others)) * shared);
  return squares / (noise * noise);
}

/// Numbers of the first terms that are estimated: choices are not.
Eigen::Index number_count(const std::vector<EffectTerm>& terms, std::size_t first) {
  Eigen::Index count = 0;
  for (std::size_t t = 0; t < first; ++t)
    for (const EffectParameter& p : term_effect(terms[t]).parameters) count += p.is_choice ? 0 : 1;
  return count;
}

class Pruning {
 public:
  Pruning(const Session& session, const ImprovementOptions& options, double most, ModelChange& change)
      : session_(session), options_(options), most_(most), change_(change) {}

  void run() {
    drop_what_is_no_longer_needed();
    thin_out();
    if (group_count() <= most_groups_each_time) exchange_names();
    look_for_forms_again();
  }

 private:
  const std::vector<EffectTerm>& terms() const { return change_.model->model_options.estimated; }

  double threshold() {
    Diagnosis& d = *change_.model;
    if (d.threshold == 0) d.threshold = threshold_of(session_, diagnosis_options(options_), d);
    return d.threshold;
  }

  /// Of the present model, for all that it estimates.
  double ln_evidence(const NoiseModel& by) {
    if (!ln_evidence_) ln_evidence_ = compute_ln_evidence(change_.model->model, by);
    return *ln_evidence_;
  }

  bool goes_on() {
    if (options_.on_progress && !options_.on_progress(0.97)) change_.stopped = true;
    return !change_.stopped;
  }

  std::vector<EffectTerm> group(std::size_t first, std::size_t last) const {
    return {terms().begin() + static_cast<std::ptrdiff_t>(first), terms().begin() + static_cast<std::ptrdiff_t>(last)};
  }

  FitOptions options_without(std::size_t first, std::size_t last, const NoiseModel& by) const {
    FitOptions o = change_.model->model_options;
    set_quick(by, o);
    o.estimated.erase(o.estimated.begin() + static_cast<std::ptrdiff_t>(first),
                      o.estimated.begin() + static_cast<std::ptrdiff_t>(last));
    return o;
  }

  std::size_t first_of_names() const { return begin_of_names(terms(), options_.estimated.size()); }

  int group_count() const {
    int count = 0;
    for (std::size_t first = first_of_names(); first < terms().size(); first = end_of_group(terms(), first)) ++count;
    return count;
  }

  /// The model without these terms, fitted on the same points, and the options that go on from there.
  std::pair<CleanFit, FitOptions> fitted_without(std::size_t first, std::size_t last, const NoiseModel& by) const {
    const Session& points = change_.model->model.session;
    FitOptions o = options_without(first, last, by);
    CleanFit without{points, fit(points, o), {}};
    for (std::size_t t = 0; t < o.estimated.size(); ++t)
      o.estimated[t] = without.fit.effects[o.effects.size() + t].term;
    return {std::move(without), std::move(o)};
  }

  /// A model with something that was not there is judged by its error elsewhere too: what was refused for that does not
  /// come in another's place.
  bool take_instead(Diagnosis next, const std::string& removed) {
    if (!next.stopped && held_out_error(next) <= most_) {
      set_errors_elsewhere(*change_.model);
      if (!worse_elsewhere(*change_.model, next).empty()) {
        ++change_.models;
        return false;
      }
    }
    return take(std::move(next), removed);
  }

  /// The model in place of the present one, where it does not lift the held-out error; the step says what went.
  bool take(Diagnosis next, const std::string& removed) {
    ++change_.models;
    change_.stopped = change_.stopped || next.stopped;
    if (next.stopped || held_out_error(next) > most_) return false;
    ImprovementStep& step = change_.steps.back();
    const ImprovementStep now = find_step(next);
    step.fitted = now.fitted;
    step.held_out = now.held_out;
    step.noise = now.noise;
    step.rms_of_noise_m = now.rms_of_noise_m;
    if (!removed.empty()) step.removed += (step.removed.empty() ? "" : ", ") + removed;
    change_.model = std::move(next);
    ln_evidence_.reset();
    return true;
  }

  /// Everything added before the last step must still be worth its parameters.
  void drop_what_is_no_longer_needed() {
    for (std::size_t first = first_of_names(); !change_.stopped && first < terms().size();) {
      const std::size_t last = end_of_group(terms(), first);
      if (last == terms().size() || !drop(first, last)) first = last;
    }
  }

  bool drop(std::size_t first, std::size_t last) {
    const Diagnosis& d = *change_.model;
    const Fit& with = d.model.fit;
    const std::vector<EffectTerm> dropped = group(first, last);
    const NoiseModel by = noise_model(with);
    // To first order it cannot be said by how much a large effect is needed, but that it is.
    if (squares_without(with, d.model_options, first, last, by.noise) > 10 * threshold() + 100) return false;
    const FitOptions o = options_without(first, last, by);
    const Fit without = fit(d.model.session, o);
    FitOptions asked = d.model_options;
    asked.on_iteration = [&](int, double, const Unknowns&) { return goes_on(); };
    if (is_taken_over(dropped, d.model.session, asked, with, without) || change_.stopped) return false;
    const double gained = ln_evidence(by) - fit_evidence(without, without.problem.effect_count(), by).ln_evidence;
    const double least = options_.likely.contains(dropped.front().id) ? worth_a_place : threshold();
    if (gained >= least - (is_curve(dropped.front()) ? ln_odds_of_unnamed : 0)) return false;
    return take(model_from(session_, options_, o.estimated, estimate(without), most_), dropped.front().id);
  }

  /// Places of an effect that say nothing any more beside what was added since go: they let the others wander.
  void thin_out() {
    Fit model = change_.model->model.fit;
    FitOptions o = change_.model->model_options;
    const NoiseModel by = noise_model(model);
    set_quick(by, o);
    std::optional<double> ln_with;  // of `model`; absent: that of the present one
    for (std::size_t t = first_of_names(); t < o.estimated.size() && goes_on();) {
      const auto fewer = is_one_of_several(o.estimated, t) ? without_place(model, o, t, by, ln_with) : std::nullopt;
      if (!fewer) {
        ++t;
        continue;
      }
      o.estimated.erase(o.estimated.begin() + static_cast<std::ptrdiff_t>(t));
      for (std::size_t k = 0; k < o.estimated.size(); ++k) o.estimated[k] = fewer->effects[o.effects.size() + k].term;
      model = *fewer;
    }
    if (o.estimated.size() == terms().size() || change_.stopped) return;
    const double most = std::min(most_, as_good * held_out_error(*change_.model));
    ++change_.models;
    Diagnosis next = model_from(session_, options_, o.estimated, estimate(model), most);
    if (held_out_error(next) <= most) take(std::move(next), "");
  }

  static bool is_one_of_several(const std::vector<EffectTerm>& all, std::size_t t) {
    return (t > 0 && all[t - 1].id == all[t].id && !is_small(all[t - 1])) ||
           (t + 1 < all.size() && all[t + 1].id == all[t].id);
  }

  /// The fit without one place, whose evidence is then `ln_with`; nothing where the place is worth its numbers.
  std::optional<Fit> without_place(const Fit& with, const FitOptions& options, std::size_t place, const NoiseModel& by,
                                   std::optional<double>& ln_with) {
    const double numbers = static_cast<double>(options.estimated[place].values.size());
    if (squares_without(with, options, place, place + 1, by.noise) > 2 * numbers + 4) return std::nullopt;
    FitOptions fewer = options;
    fewer.estimated.erase(fewer.estimated.begin() + static_cast<std::ptrdiff_t>(place));
    fewer.start = estimate(with);
    Fit without = fit(change_.model->model.session, fewer);
    if (!without.converged()) return std::nullopt;
    const double ln_without = fit_evidence(without, without.problem.effect_count(), by).ln_evidence;
    if ((ln_with ? *ln_with : ln_evidence(by)) - ln_without > worth_a_place) return std::nullopt;
    ln_with = ln_without;
    return without;
  }

  /// Names and curves that stood in for another name are exchanged; a name that was added last stays.
  void exchange_names() {
    for (std::size_t first = first_of_names(); !change_.stopped && first < terms().size();) {
      const std::size_t last = end_of_group(terms(), first);
      if (last == terms().size() && !is_curve(terms()[first])) return;
      const std::string removed = terms()[first].id;
      threshold();
      const auto exchange = better_name(*change_.model, first, last, [&] { return goes_on(); });
      // A name that has gone does not come back for the one that came: they would take turns for ever.
      if (exchange && !change_.stopped && !gone_.contains(exchange->id) &&
          take(model_from(session_, options_, exchange->options.estimated, exchange->options.start, most_), removed)) {
        ImprovementStep& step = change_.steps.back();
        step.exchanged.push_back(exchange->id);
        gone_.insert(removed);
        continue;  // the next group has moved here; the new name stands last
      }
      first = last;
    }
  }

  /// With other terms beside it, a curve may have another form, and a slip another moment.
  void look_for_forms_again() {
    for (std::size_t first = first_of_names(); !change_.stopped && first < terms().size();) {
      const std::size_t last = end_of_group(terms(), first);
      const bool is_earlier = last < terms().size();
      if (is_earlier && is_curve(terms()[first])) look_for_curve(first, last);
      if (is_earlier && slip_order(group(first, last))) look_for_moment(first, last);
      first = last;
    }
  }

  static std::pair<Refit, Refit> refitted_side_by_side(const CleanFit& without, const FitOptions& options,
                                                       const std::vector<EffectTerm>& one,
                                                       const std::vector<EffectTerm>& other, const NoiseModel& by,
                                                       double before) {
    std::pair<Refit, Refit> both;
    each_part(2, true, [&](int i) {
      (i == 0 ? both.first : both.second) = refit_with(without, options, i == 0 ? one : other, by, before);
    });
    return both;
  }

  void look_for_moment(std::size_t first, std::size_t last) {
    const NoiseModel by = noise_model(change_.model->model.fit);
    const std::vector<EffectTerm> present = group(first, last);
    const auto [without, o] = fitted_without(first, last, by);
    const std::vector<EffectTerm> other = with_best_orders(without, present, by);
    if (slip_order(other) == slip_order(present) || !goes_on()) return;
    const double before = compute_ln_evidence(without, by);
    const auto [now, then] = refitted_side_by_side(without, o, present, other, by, before);
    if (then.fit.converged() && then.ln_bayes_factor > now.ln_bayes_factor + clearly_better) replace(first, then);
  }

  /// At their place the terms that a refit without those of the group at `first` has added; from the refit's answer.
  void replace(std::size_t first, const Refit& refit) {
    std::vector<EffectTerm> all = refit.options.estimated;
    Unknowns start = estimate(refit.fit);
    const auto added = static_cast<std::ptrdiff_t>(refit.added), at = static_cast<std::ptrdiff_t>(first);
    const Eigen::Index numbers = number_count(all, all.size()), before = number_count(all, first);
    const Eigen::Index own = numbers - number_count(all, all.size() - refit.added);
    std::rotate(start.effects.data() + start.effects.size() - numbers + before,
                start.effects.data() + start.effects.size() - own, start.effects.data() + start.effects.size());
    std::rotate(all.begin() + at, all.end() - added, all.end());
    take_instead(model_from(session_, options_, all, start, most_), "");
  }

  void look_for_curve(std::size_t first, std::size_t last) {
    const NoiseModel by = noise_model(change_.model->model.fit);
    const std::vector<EffectTerm> present = group(first, last);
    const auto [without, o] = fitted_without(first, last, by);
    Candidates none;
    none.problem = with_motions(without.fit.problem);
    none.base_effects = none.problem.effect_count();
    const LinearModel linear = linear_model(none.problem, estimate(without.fit), none.base_effects, by.noise);
    const std::vector<Variable> variables = list_variables(none.problem, estimate(without.fit));
    const Ranking ranking = rank(linear, by.knowledge, none, variables);
    if (ranking.empirical_errors.empty() || !goes_on()) return;
    const WhitenedModel w = whiten(linear, ranking.empirical_errors.front().repeatability, by.knowledge);
    const auto found =
        find_curve(w, by.knowledge, none.problem, variables, ranking.empirical_errors, present.front().id);
    if (!found || formula_text(*found->term.own->definition) == formula_text(*present.front().own->definition)) return;
    const double before = compute_ln_evidence(without, by);
    const auto [now, other] = refitted_side_by_side(without, o, present, {found->term}, by, before);
    // Both were chosen in as many ways.
    if (other.fit.converged() && other.ln_bayes_factor > now.ln_bayes_factor + clearly_better) replace(first, other);
  }

  const Session& session_;
  const ImprovementOptions& options_;
  double most_;
  ModelChange& change_;
  std::set<std::string> gone_;         // names that were exchanged for others
  std::optional<double> ln_evidence_;  // of the present model; absent: not asked yet
};

}  // namespace

std::size_t end_of_group(const std::vector<EffectTerm>& terms, std::size_t first) {
  std::size_t last = first + 1;
  while (last < terms.size() && terms[last].id == terms[first].id) ++last;
  return last;
}

void prune(const Session& session, const ImprovementOptions& options, double most, ModelChange& change) {
  Pruning(session, options, most, change).run();
}

}  // namespace handsight
