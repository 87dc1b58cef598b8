// SPDX-License-Identifier: Apache-2.0
// What a judge says of the worlds of fixtures/collection_worlds.h who knows how they are made: the noise, that one
// cause is hidden at one place, and by how much it shows. No program can name more of them.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "diagnosis/evidence/candidates.h"
#include "diagnosis/evidence/prior_odds.h"
#include "fixtures/collection_worlds.h"

namespace handsight::trials {

struct JudgedCause {
  std::string id, place;
  double ln_likelihood = 0;
};

/// chi-squared of what a fit with these effects leaves.
inline double left_with(const Session& s, std::vector<EffectTerm> terms) {
  for (EffectTerm& t : terms)
    for (std::size_t p = 0; p < t.values.size(); ++p)
      if (!term_effect(t).parameters[p].is_choice) t.values[p] = 0;
  FitOptions options;
  options.smallest_step = 1e-9;  // without an error of the robot's own, which there is not
  options.estimated = std::move(terms);
  const Fit f = fit(s, options);
  return f.solution.normal.data_cost() / (f.noise.value() * f.noise.value());
}

inline int count_numbers(const EffectTerm& term) {
  const std::vector<EffectParameter>& all = term_effect(term).parameters;
  return static_cast<int>(std::count_if(all.begin(), all.end(), [](const EffectParameter& p) { return !p.is_choice; }));
}

/// ln of the likelihood of a cause of so many numbers with noncentrality `shown_together`: where its numbers are
/// counted in their sigmas it is a point of a sphere of that radius, each as likely, and the fit's answer is a point at
/// the distance sqrt(without - with).
inline double ln_likelihood(double without, double with, int numbers) {
  const double radius = std::sqrt(fixture::shown_together), found = std::sqrt(std::max(without - with, 0.0));
  const double half = 0.5 * numbers;
  const double ln_area = std::log(2) + half * std::log(std::numbers::pi) - std::lgamma(half) +
                         (numbers - 1) * (std::log(radius) - 0.5 * std::log(2 * std::numbers::pi));
  return -0.5 * (with + (found - radius) * (found - radius)) - ln_area;
}

/// Each effect of the catalogue at each place alone, the likeliest first; what explains by time is left out.
inline std::vector<JudgedCause> judge(const Session& s) {
  FitOptions plain;
  plain.smallest_step = 1e-9;
  const Candidates candidates = all_candidates(fit(s, plain).problem);
  const double without = left_with(s, {});
  std::vector<JudgedCause> causes;
  for (const CandidateEffect& effect : candidates.effects)
    for (const CandidateUnit& unit : effect.units) {
      if (follows_time(unit.term) || is_change_between_sessions(unit.term)) continue;
      const std::string place = place_name(*effect.effect, unit.term.place, s.robot);
      const double with = left_with(s, {unit.term});
      causes.push_back({unit.term.id, place, ln_likelihood(without, with, static_cast<int>(unit.count))});
    }
  std::sort(causes.begin(), causes.end(),
            [](const JudgedCause& a, const JudgedCause& b) { return a.ln_likelihood > b.ln_likelihood; });
  return causes;
}

}  // namespace handsight::trials
