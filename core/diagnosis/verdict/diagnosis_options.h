// SPDX-License-Identifier: Apache-2.0
// What a diagnosis is asked.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "diagnosis/outliers/snooping.h"
#include "effects/effect.h"
#include "estimation/problem/problem.h"

namespace handsight {

struct DiagnosisOptions {
  std::vector<EffectTerm> effects;    // in the model, held
  std::vector<EffectTerm> estimated;  // in the model, estimated; start values
  std::size_t fewest = 10;            // used observations; with fewer the verdict is too_few_observations
  int refitted = 3;                   // how many of the best are fitted in full
  bool with_held_out = true;          // their held-out errors too
  bool with_regions = true;           // FitReport::held_out_region
  bool only_model = false;            // fitted and reported; what is missing is not asked
  bool with_curves = true;            // the best unnamed curve is fitted in full too, where it passes
  std::optional<double> threshold;    // ln of the Bayes factor that counts; absent: simulated on these poses
  std::optional<Unknowns> start;      // of a fit of nearly the same model
  std::optional<CleanFit> fitted;     // the model as it is already fitted (of these effects); saves a fit
  /// px, or m with a tracker: a model that is worse held out is fitted and reported, and nothing more is asked of it.
  std::optional<double> most_held_out;
  /// Every iteration of the model's own fits: cost and unknowns; returning false stops.
  std::function<bool(int iteration, double cost, const Unknowns&)> on_iteration;
  /// Called between steps, and at every iteration of the candidates' fits, with the share of the work done; returning
  /// false stops (the result is then empty).
  std::function<bool(double done)> on_progress;
};

}  // namespace handsight
