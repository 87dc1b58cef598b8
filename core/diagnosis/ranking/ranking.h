// SPDX-License-Identifier: Apache-2.0
// The catalogue's effects and the empirical error terms in the order of their evidence, with the joints' repeatability
// profiled out and a choice of joints inside every effect (docs/method.md, "Ranking what is missing").
#pragma once

#include "diagnosis/curves/empirical_errors.h"
#include "diagnosis/evidence/candidates.h"

namespace handsight {

/// Prior odds against an unnamed curve: named physical effects are what robots usually have.
inline constexpr double ln_odds_of_unnamed = -3;

/// The same for what follows this: a drift without a name is as rare as one that has it, besides.
double ln_odds_of_unnamed_along(const Variable& variable);

struct RankedEffect {
  const CandidateEffect* candidate = nullptr;
  double ln_bayes_factor = 0;      // the mean over all choices of places, at the scatter that suits it best; odds
                                   // against what is rare included (prior_odds.h)
  std::vector<std::size_t> units;  // the best choice of places
  double ln_best = 0;              // of that choice alone
  LinearEstimate estimate;         // of its parameters, unit by unit, in prior sigmas
  Repeatability repeatability;     // at which
  double gained_squares = 0;       // chi-squared that the best choice takes away
  int parameters = 0;              // of the best choice
  double visibility = 0;           // chi-squared expected of the prior sigma at all places: below 30 it cannot be seen
};

struct RankedEmpiricalError {
  EmpiricalError empirical_error;
  double ln_bayes_factor = 0;  // prior odds against anything unnamed included
  Repeatability repeatability;
};

struct Ranking {
  std::vector<RankedEffect> effects;                   // best first
  std::vector<RankedEmpiricalError> empirical_errors;  // best first
  Repeatability repeatability;                         // that suits the model as it is
  std::vector<Repeatability> scatters;                 // that were tried
};

/// A ranked effect at its linear estimate.
std::vector<EffectTerm> terms_with_values(const RankedEffect& ranked);

Ranking rank(const LinearModel& model, const NoiseKnowledge& noise, const Candidates& candidates,
             const std::vector<Variable>& variables);

}  // namespace handsight
