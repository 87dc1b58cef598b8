// SPDX-License-Identifier: Apache-2.0
#include "estimation/fit/fit_result.h"

namespace handsight {

std::vector<EffectTerm> list_terms(const Fit& fit) {
  std::vector<EffectTerm> terms;
  for (const FittedEffect& e : fit.effects) terms.push_back(e.term);
  return terms;
}

}  // namespace handsight
