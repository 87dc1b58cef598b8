// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/evidence/prior_odds.h"

namespace handsight {

bool follows_time(const EffectTerm& term) {
  return slip_order({term}).has_value() || term_effect(term).check_reads == CheckReads::start_to_end;
}

bool is_change_between_sessions(const EffectTerm& term) { return term.id.ends_with("_changed"); }

double ln_odds_against(const EffectTerm& term) {
  if (is_change_between_sessions(term)) return ln_odds_against_change;
  if (!follows_time(term)) return 0;
  return slip_order({term}) ? ln_odds_against_slip : ln_odds_against_drift;
}

std::optional<double> slip_order(const std::vector<EffectTerm>& terms) {
  for (const EffectTerm& term : terms) {
    const Effect& effect = term_effect(term);
    for (std::size_t p = 0; p < effect.parameters.size(); ++p)
      if (effect.parameters[p].is_choice && effect.parameters[p].choices.empty()) return term.values[p];
  }
  return std::nullopt;
}

}  // namespace handsight
