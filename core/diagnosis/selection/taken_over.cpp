// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/selection/taken_over.h"

#include <algorithm>

#include "diagnosis/ranking/curves.h"
#include "diagnosis/verdict/stand_in.h"

namespace handsight {

bool is_taken_over(const std::vector<EffectTerm>& gone, const Fit& with, const Fit& without) {
  const Chain& chain = with.problem.source->chain;
  if (is_plausible(gone, chain)) return false;
  const std::vector<EffectTerm> before = list_terms(with), after = list_terms(without);
  return std::any_of(after.begin(), after.end(), [&](const EffectTerm& t) {
    const auto same = std::find_if(before.begin(), before.end(),
                                   [&](const EffectTerm& b) { return b.id == t.id && b.place == t.place; });
    return same != before.end() && !is_curve(t) && is_plausible({*same}, chain) && !is_plausible({t}, chain);
  });
}

}  // namespace handsight
