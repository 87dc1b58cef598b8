// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/ranking/refitting.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "diagnosis/evidence/repeatability_levels.h"
#include "effects/term_numbers.h"

namespace handsight {
namespace {

/// The prior sigmas of a fit's last effect numbers, in units of what its linear model lets them be.
Eigen::ArrayXd plausible_in_model(const Fit& fit, const Problem& problem, Eigen::Index last) {
  const Eigen::VectorXd values = estimate(fit).effects.tail(last);
  const auto first = problem.columns_of_effects.size() - static_cast<std::size_t>(last);
  Eigen::ArrayXd sizes(last);
  for (Eigen::Index i = 0; i < last; ++i)
    sizes[i] = 1 / times_prior_sigma(values[i] / problem.columns_of_effects[first + static_cast<std::size_t>(i)].sigma);
  return sizes;
}

/// With the prior sigmas of the last columns times these.
BasePrior at_scales(const BasePrior& plain, const Eigen::ArrayXd& times) {
  const Eigen::Index added = times.size();
  const Eigen::ArrayXd squares = times * times;
  BasePrior scaled = plain;
  scaled.precision.tail(added).array() /= squares;
  scaled.gradient.tail(added).array() /= squares;
  scaled.cost += ((1 / squares - 1) * plain.gradient.tail(added).array().square()).sum();
  return scaled;
}

}  // namespace

FitEvidence fit_evidence(const Fit& fit, Eigen::Index first_new, const NoiseModel& noise_model) {
  const Problem problem = with_motions(fit.problem);
  const LinearModel model = linear_model(problem, estimate(fit), problem.effect_count(), noise_model.noise);
  const Eigen::ArrayXd plausible = plausible_in_model(fit, problem, problem.effect_count() - first_new);
  FitEvidence best{-1e300, {}};
  for (const Repeatability& repeatability : repeatability_levels(model, noise_model.knowledge)) {
    const BaseEvidence evidence(model, repeatability, noise_model.knowledge);
    const auto at_scale = [&](double scale) {
      return evidence.ln_with(at_scales(model.prior, scale * plausible)) - (scale * plausible).log().sum();
    };
    std::array<double, prior_scales.size()> values{};
    for (std::size_t i = 0; i < values.size() && plausible.size() > 0; ++i) values[i] = at_scale(prior_scales[i]);
    const double value = plausible.size() > 0 ? ln_over_scales(values) : at_scale(1);
    if (value > best.ln_evidence) best = {value, repeatability};
  }
  return best;
}

double compute_ln_evidence(const CleanFit& model, const NoiseModel& noise_model) {
  return fit_evidence(model.fit, model.fit.problem.effect_count(), noise_model).ln_evidence;
}

Refit refit_with(const CleanFit& model, const FitOptions& model_options, const std::vector<EffectTerm>& added,
                 const NoiseModel& noise_model, std::optional<double> ln_before) {
  Refit r;
  r.options = model_options;
  r.options.start = estimate(model.fit);
  r.options.estimated.insert(r.options.estimated.end(), added.begin(), added.end());
  set_quick(noise_model, r.options);
  r.added = added.size();
  r.fit = fit(model.session, r.options);
  for (std::size_t t = 0; t < r.options.estimated.size(); ++t)
    r.options.estimated[t] = r.fit.effects[r.options.effects.size() + t].term;
  r.options.start = estimate(r.fit);
  if (r.fit.solution.stopped) return r;
  const Eigen::Index before = model.fit.problem.effect_count();
  r.ln_bayes_factor = fit_evidence(r.fit, before, noise_model).ln_evidence -
                      (ln_before ? *ln_before : compute_ln_evidence(model, noise_model));
  return r;
}

namespace {

/// The order of each term that has one, sought up to `reach` used observations before and after its own.
std::vector<EffectTerm> with_orders_within(const CleanFit& model, const std::vector<EffectTerm>& terms,
                                           const NoiseModel& noise_model, std::ptrdiff_t reach) {
  const NoiseKnowledge& knowledge = noise_model.knowledge;
  std::vector<EffectTerm> settled = terms;
  const Problem& problem = model.fit.problem;
  for (EffectTerm& term : settled) {
    const Effect& effect = term_effect(term);
    const auto order = std::find_if(effect.parameters.begin(), effect.parameters.end(),
                                    [](const EffectParameter& p) { return p.is_choice && p.choices.empty(); });
    if (order == effect.parameters.end()) continue;
    const auto place = static_cast<std::size_t>(order - effect.parameters.begin());
    std::vector<double> orders;
    for (const ProblemObservation& o : problem.observations)
      orders.push_back(problem.source->states[static_cast<std::size_t>(o.index)].order);
    const auto here = std::lower_bound(orders.begin(), orders.end(), term.values[place]) - orders.begin();
    const auto from = std::max<std::ptrdiff_t>(1, here - reach);
    const auto to = std::min<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(orders.size()) - 1, here + reach);
    if (from > to) continue;
    const Candidates near =
        candidates_at_orders(problem, term, std::vector<double>(orders.begin() + from, orders.begin() + to + 1));
    const LinearModel linear = linear_model(near.problem, estimate(model.fit), near.base_effects, noise_model.noise);
    const WhitenedModel w = whiten(linear, {}, knowledge);
    double best = -1e300;
    for (const CandidateUnit& unit : near.effects.front().units) {
      const Score s = score(w, unit.first, unit.count);
      const double factor = ln_bayes_factor(s, w, knowledge);
      if (factor <= best) continue;
      best = factor;
      const LinearEstimate e = linear_estimate(s, w, knowledge);
      Eigen::Index i = 0;
      for (std::size_t p = 0; p < effect.parameters.size(); ++p)
        term.values[p] =
            effect.parameters[p].is_choice ? unit.term.values[p] : e.value[i++] * near.effects.front().sizes[p];
    }
  }
  return settled;
}

}  // namespace

std::vector<EffectTerm> with_settled_orders(const CleanFit& model, const std::vector<EffectTerm>& terms,
                                            const NoiseModel& noise_model) {
  const auto reach = static_cast<std::ptrdiff_t>(model.fit.problem.observations.size() / 24 + 2);
  return with_orders_within(model, terms, noise_model, reach);
}

std::vector<EffectTerm> with_best_orders(const CleanFit& model, const std::vector<EffectTerm>& terms,
                                         const NoiseModel& noise_model) {
  return with_orders_within(model, terms, noise_model,
                            static_cast<std::ptrdiff_t>(model.fit.problem.observations.size()));
}

bool further_effect_passes(const Refit& refit, double threshold) {
  const Fit& f = refit.fit;
  const NoiseModel w = noise_model(f);
  const Candidates candidates = all_candidates(f.problem);
  const LinearModel model = linear_model(candidates.problem, estimate(f), candidates.base_effects, w.noise);
  const Ranking ranking = rank(model, w.knowledge, candidates, {});
  return !ranking.effects.empty() && ranking.effects.front().ln_bayes_factor >= threshold;
}

namespace {

std::vector<Eigen::Index> columns_of_units(const RankedEffect& r, bool all) {
  std::vector<Eigen::Index> columns;
  const EffectScope scope = r.candidate->effect->scope;
  const bool everywhere = all && (scope == EffectScope::joint || scope == EffectScope::mimic_joint);
  for (std::size_t u = 0; u < r.candidate->units.size(); ++u) {
    if (!everywhere && std::find(r.units.begin(), r.units.end(), u) == r.units.end()) continue;
    for (Eigen::Index i = 0; i < r.candidate->units[u].count; ++i) columns.push_back(r.candidate->units[u].first + i);
  }
  return columns;
}

}  // namespace

double imitated_share(const Score& all, const RankedEffect& a, const RankedEffect& b) {
  const std::vector<Eigen::Index> own = columns_of_units(a, false), other = columns_of_units(b, true);
  const Eigen::VectorXd value = a.estimate.value;
  const double signal = value.dot(all.information(own, own) * value);
  if (!(signal > 0)) return 0;
  const Eigen::VectorXd shared = all.information(other, own) * value;
  Eigen::MatrixXd information = all.information(other, other);
  information.diagonal().array() += 1.0 / 9;  // three prior sigmas
  return shared.dot(information.ldlt().solve(shared)) / signal;
}

namespace {

EffectTerm likeliest_choice(const CleanFit& model, const Candidates& choices, EffectTerm term, const NoiseModel& by) {
  const LinearModel linear = linear_model(choices.problem, estimate(model.fit), choices.base_effects, by.noise);
  const WhitenedModel w = whiten(linear, {}, by.knowledge);
  double best = -1e300;
  for (const CandidateUnit& unit : choices.effects.front().units) {
    const double factor = ln_bayes_factor(score(w, unit.first, unit.count), w, by.knowledge);
    if (factor <= best) continue;
    best = factor;
    term.values = unit.term.values;
  }
  return term;
}

}  // namespace

std::vector<EffectTerm> best_choices(const Session& session, const std::vector<EffectTerm>& terms) {
  std::vector<EffectTerm> settled = terms;
  std::optional<CleanFit> model;
  for (EffectTerm& term : settled) {
    const Effect& effect = term_effect(term);
    if (std::none_of(effect.parameters.begin(), effect.parameters.end(),
                     [](const EffectParameter& p) { return p.is_choice; }))
      continue;
    if (!model) model = clean_fit(session, {});
    const Fit& f = model->fit;
    const NoiseModel by = noise_model(f);
    const Candidates choices = choices_at_place(f.problem, term);
    const bool has_choice = !choices.effects.empty() && !choices.effects.front().units.empty();
    if (has_choice) term = likeliest_choice(*model, choices, term, by);
    if (has_choice) term = with_settled_orders(*model, {term}, by).front();
    clear_numbers(term);
  }
  return settled;
}

}  // namespace handsight
