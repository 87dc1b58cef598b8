// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/verdict/stand_in.h"

#include <algorithm>
#include <cmath>

#include "diagnosis/verdict/finding.h"

namespace handsight {

bool is_too_large(const EffectTerm& term, const Chain& chain) {
  const Effect& effect = term_effect(term);
  for (std::size_t p = 0; p < effect.parameters.size(); ++p)
    if (is_free(effect, term, p) && std::abs(term.values[p]) > largest_built * prior_sigma(effect.parameters[p], chain))
      return true;
  return false;
}

std::vector<StandIn> stand_ins(const Fit& fit) {
  std::vector<StandIn> list;
  if (!fit.problem.source) return list;
  const Chain& chain = fit.problem.source->chain;
  for (const FittedEffect& f : fit.effects) {
    const bool is_estimated = std::any_of(f.sigmas.begin(), f.sigmas.end(), [](double s) { return s > 0; });
    if (!is_estimated || term_effect(f.term).is_unnamed()) continue;
    const bool back = pushes_back({f.term}, {f.sigmas});
    if (!back && !is_too_large(f.term, chain)) continue;
    auto same = std::find_if(list.begin(), list.end(), [&](const StandIn& s) { return s.id == f.term.id; });
    if (same == list.end()) same = list.insert(list.end(), StandIn{.id = f.term.id});
    const std::string place = place_name(term_effect(f.term), f.term.place, chain.robot);
    if (!place.empty()) same->where.push_back(place);
    same->pushes_back = same->pushes_back || back;
  }
  return list;
}

}  // namespace handsight
