// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/selection/taken_over.h"

#include <algorithm>
#include <cmath>

#include "diagnosis/evidence/noise_model.h"
#include "diagnosis/ranking/curves.h"
#include "diagnosis/verdict/stand_in.h"

namespace handsight {

bool is_taken_over(const std::vector<EffectTerm>& gone, const Fit& with, const Fit& without) {
  constexpr double as_well = 20;  // chi-squared
  const Chain& chain = with.problem.source->chain;
  if (is_plausible(gone, chain)) return false;
  const double growth = without.solution.normal.data_cost() - with.solution.normal.data_cost();
  if (growth > as_well * std::pow(noise_model(with).noise, 2)) return false;
  const std::vector<EffectTerm> before = list_terms(with), after = list_terms(without);
  return std::any_of(after.begin(), after.end(), [&](const EffectTerm& t) {
    const auto same = std::find_if(before.begin(), before.end(),
                                   [&](const EffectTerm& b) { return b.id == t.id && b.place == t.place; });
    return same != before.end() && !is_curve(t) && is_plausible({*same}, chain) && !is_plausible({t}, chain);
  });
}

}  // namespace handsight
