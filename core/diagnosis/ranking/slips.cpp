// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/ranking/slips.h"

#include <algorithm>
#include <cmath>

#include "estimation/report/fit_report.h"

namespace handsight {
namespace {

constexpr int most_blocks = 10;
constexpr double least_sigmas = 2.3;  // of the sum of what all observations gain

}  // namespace

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

bool slip_is_confirmed(const Session& session, const Fit& without, const FitOptions& without_options, const Fit& with,
                       const FitOptions& with_options, double order) {
  const auto count = static_cast<int>(without.problem.observations.size());
  const int blocks = std::min(most_blocks, count / 3);
  if (blocks < 3) return true;  // too few to ask
  const std::vector<double> before = held_out_in_blocks(session, without, without_options, blocks);
  const std::vector<double> after = held_out_in_blocks(session, with, with_options, blocks);
  if (before.size() != after.size() || static_cast<int>(before.size()) != count) return true;
  // By the gains' own spread: nothing is taken for normal, and a few observations with much to gain prove little.
  double earlier = 0, later = 0, squares = 0;
  for (int i = 0; i < count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double gain = before[at] - after[at];
    const auto index = static_cast<std::size_t>(without.problem.observations[at].index);
    (without.problem.source->states[index].order < order ? earlier : later) += gain;
    squares += gain * gain;
  }
  return earlier > 0 && later > 0 && earlier + later > least_sigmas * std::sqrt(squares);
}

}  // namespace handsight
