// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/verdict/small_beside.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "diagnosis/space/spreading.h"
#include "diagnosis/verdict/stand_in.h"
#include "effects/units.h"

namespace handsight {
namespace {

/// Within what is usual, in every number.
bool is_usual(const EffectTerm& term, const Chain& chain) {
  const Effect& effect = term_effect(term);
  for (std::size_t p = 0; p < effect.parameters.size(); ++p)
    if (!effect.parameters[p].is_choice && std::abs(term.values[p]) > prior_sigma(effect.parameters[p], chain))
      return false;
  return true;
}

using Refitting = std::function<Refit(const std::vector<EffectTerm>&)>;

double gain_beside(const Refit& candidate, const Refitting& refit) {
  const std::vector<EffectTerm> all_terms = list_terms(candidate.fit);
  const std::size_t first = all_terms.size() - candidate.added;
  // Of a robot that repeats: what is left of small deviations passes for scatter else.
  const ModelSpace all(candidate.fit, candidates_of(candidate.fit.problem, small_in_every_robot()), first, 0,
                       Repeatability{});
  const Chosen present = all.present();
  const Spreading spreading(all, present);
  const std::vector<SpreadName> spread = spreading.sum(present, std::nullopt, std::nullopt, largest_small).likeliest;
  // What is not usual already to first order need not be fitted.
  if (spread.empty() || spreading.estimate_largest(present, spread) > 1) return 0;
  std::vector<EffectTerm> terms(all_terms.begin() + static_cast<std::ptrdiff_t>(first), all_terms.end());
  const std::vector<EffectTerm> small = list_terms(all, present, spread);
  terms.insert(terms.end(), small.begin(), small.end());
  const Refit beside = refit(terms);
  if (!beside.fit.solution.normal.in_front) return 0;
  const Chain& chain = candidate.fit.problem.source->chain;
  const std::vector<EffectTerm> fitted = list_terms(beside.fit);
  const auto stays_small = [&](const EffectTerm& t) { return is_usual(t, chain); };
  if (!std::all_of(fitted.end() - static_cast<std::ptrdiff_t>(small.size()), fitted.end(), stays_small)) return 0;
  const double gain =
      beside.ln_bayes_factor - candidate.ln_bayes_factor - static_cast<double>(spread.size()) * ln_ways_of_size();
  return std::max(gain, 0.0);
}

}  // namespace

double gain_by_small_deviations(const Refit& candidate, const Refitting& refit) {
  const std::vector<EffectTerm> all = list_terms(candidate.fit);
  const Chain& chain = candidate.fit.problem.source->chain;
  std::vector<EffectTerm> large(all.end() - static_cast<std::ptrdiff_t>(candidate.added), all.end());
  std::erase_if(large, [&](const EffectTerm& t) { return is_plausible({t}, chain); });
  const double gain = gain_beside(candidate, refit);
  if (large.empty() || large.size() == candidate.added) return gain;
  const Refit alone = refit(large);
  if (!alone.fit.solution.normal.in_front) return gain;
  return std::max(gain, alone.ln_bayes_factor - candidate.ln_bayes_factor + gain_beside(alone, refit));
}

}  // namespace handsight
