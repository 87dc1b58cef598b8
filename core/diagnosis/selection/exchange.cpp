// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/selection/exchange.h"

#include <algorithm>
#include <mutex>

#include "base/threads.h"
#include "diagnosis/evidence/prior_odds.h"
#include "diagnosis/ranking/curves.h"
#include "diagnosis/ranking/refitting.h"
#include "diagnosis/selection/taken_over.h"
#include "diagnosis/verdict/candidate_report.h"
#include "diagnosis/verdict/stand_in.h"
#include "effects/term_numbers.h"

namespace handsight {
namespace {

constexpr double clearly_above = 3;  // ln of a Bayes factor, odds of 20
constexpr std::size_t most = 3;      // names that are fitted in full
constexpr double nearly = 0.9;       // of the present name's linear evidence: full fits may turn it round

/// Evidence of a full fit with the ways counted in which the effect could have sat elsewhere.
double evidence_of(const Refit& refit, const RankedEffect& ranked) {
  return refit.ln_bayes_factor + ranked.ln_bayes_factor - ranked.ln_best;
}

/// Is what is large only called otherwise: of usual size beside it, `other` is as large in its place?
bool comes_as_another(const std::vector<EffectTerm>& present, const Diagnosis& model, const Refit& other,
                      const FitOptions& quick) {
  if (is_plausible(present, model.model.fit.problem.source->chain)) return false;
  FitOptions both = quick;
  both.estimated = model.model_options.estimated;
  std::vector<EffectTerm> terms = list_terms(other.fit);
  terms.erase(terms.begin(), terms.end() - static_cast<std::ptrdiff_t>(other.added));
  for (EffectTerm& t : terms) clear_numbers(t);
  both.estimated.insert(both.estimated.end(), terms.begin(), terms.end());
  const Fit with = fit(model.model.session, both);
  return with.converged() && is_taken_over(present, model.model.session, both, with, other.fit);
}

}  // namespace

std::optional<Exchange> better_name(const Diagnosis& model, std::size_t first, std::size_t last,
                                    const std::function<bool()>& goes_on) {
  const std::vector<EffectTerm>& all = model.model_options.estimated;
  const std::vector<EffectTerm> present(all.begin() + static_cast<std::ptrdiff_t>(first),
                                        all.begin() + static_cast<std::ptrdiff_t>(last));
  const NoiseModel by = noise_model(model.model.fit);
  FitOptions o = model.model_options;
  o.estimated.erase(o.estimated.begin() + static_cast<std::ptrdiff_t>(first),
                    o.estimated.begin() + static_cast<std::ptrdiff_t>(last));
  set_quick(by, o);
  std::mutex one_at_a_time;
  o.on_iteration = [&](int, double, const Unknowns&) {
    const std::scoped_lock lock(one_at_a_time);
    return goes_on();
  };
  const CleanFit without{model.model.session, fit(model.model.session, o), {}};
  if (without.fit.solution.stopped) return std::nullopt;
  if (is_taken_over(present, model.model.session, model.model_options, model.model.fit, without.fit))
    return std::nullopt;
  for (std::size_t t = 0; t < o.estimated.size(); ++t) o.estimated[t] = without.fit.effects[o.effects.size() + t].term;

  const Candidates candidates = all_candidates(without.fit.problem);
  const LinearModel linear = linear_model(candidates.problem, estimate(without.fit), candidates.base_effects, by.noise);
  const Ranking ranking = rank(linear, by.knowledge, candidates, {});
  const bool unnamed = is_curve(present.front());
  const auto own = std::find_if(ranking.effects.begin(), ranking.effects.end(),
                                [&](const RankedEffect& r) { return r.candidate->effect->id == present.front().id; });
  if (own == ranking.effects.end() && !unnamed) return std::nullopt;
  std::vector<const RankedEffect*> others;
  for (std::size_t i = 0; i < std::min(most, ranking.effects.size()); ++i) {
    const RankedEffect& r = ranking.effects[i];
    if (!unnamed && &r == &*own) continue;
    // A size that scales what was measured is judged by the measurements' own density (verdict/diagnosis.cpp).
    if (r.candidate->effect->id == "target_scale" && !without.fit.problem.rig) continue;
    const bool may_be_of_time = follows_time(present.front()) || is_curve_of_time(present.front());
    if (follows_time(r.candidate->units.front().term) && !may_be_of_time) continue;
    const double least = unnamed ? model.threshold : nearly * own->ln_bayes_factor;
    if (r.ln_bayes_factor < least) break;
    others.push_back(&r);
  }
  if (others.empty() || !goes_on()) return std::nullopt;
  const double ln_before = compute_ln_evidence(without, by);
  std::vector<Refit> refits(others.size() + 1);  // the present name's last
  each_part(static_cast<int>(refits.size()), true, [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    const std::vector<EffectTerm> terms =
        at < others.size() ? with_settled_orders(without, terms_with_values(*others[at]), by) : present;
    refits[at] = refit_with(without, o, terms, by, ln_before);
  });
  const Refit& now = refits.back();
  double best_evidence =
      unnamed ? now.ln_bayes_factor - ln_odds_against_curve(present.front()) : evidence_of(now, *own) + clearly_above;
  std::optional<Exchange> best;
  for (std::size_t i = 0; i < others.size(); ++i) {
    const Refit& other = refits[i];
    // Where a fit has not ended its evidence is less than it could be, and may be enough.
    if (!other.fit.solution.normal.in_front || evidence_of(other, *others[i]) <= best_evidence) continue;
    if (comes_as_another(present, model, other, o)) continue;
    best_evidence = evidence_of(other, *others[i]);
    const std::vector<EffectTerm> terms = list_terms(other.fit);
    best = Exchange{others[i]->candidate->effect->id,
                    {terms.end() - static_cast<std::ptrdiff_t>(other.added), terms.end()},
                    other.options};
    best->options.on_iteration = nullptr;
  }
  return goes_on() ? best : std::nullopt;
}

}  // namespace handsight
