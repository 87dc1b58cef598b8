// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/selection/cost_of_names.h"

#include "base/combinations.h"
#include "diagnosis/evidence/prior_odds.h"
#include "diagnosis/ranking/curves.h"
#include "diagnosis/selection/exchange.h"

namespace handsight {

std::map<std::string, int> places_of_effects(const Candidates& candidates) {
  std::map<std::string, int> places;
  for (const CandidateEffect& e : candidates.effects) places[e.effect->id] = static_cast<int>(e.units.size());
  return places;
}

double cost_of_names(const std::vector<EffectTerm>& terms, const std::map<std::string, int>& places,
                     double cost_of_a_name) {
  double cost = 0;
  std::map<std::string, int> counted;
  for (const EffectTerm& t : terms)
    if (counted[t.id]++ == 0) cost += cost_of_a_name + (is_curve(t) ? ln_odds_against_curve(t) : ln_odds_against(t));
  for (const auto& [id, count] : counted)
    if (const auto all = places.find(id); all != places.end() && all->second >= count)
      cost += ln_choose(all->second, count);
  return cost;
}

}  // namespace handsight
