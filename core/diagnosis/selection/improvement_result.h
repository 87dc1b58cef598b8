// SPDX-License-Identifier: Apache-2.0
// The models on the way of an improvement, and what it finds.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/message.h"
#include "diagnosis/selection/bill.h"
#include "diagnosis/selection/inclusion_probability.h"
#include "diagnosis/verdict/diagnosis_result.h"

namespace handsight {

/// A model on the way: the first as it was, then one per change.
struct ImprovementStep {
  std::string added;    // effect id; empty for the first, and where all names were sought again
  std::string removed;  // effect ids, where something added before is no longer needed, or stood in for another
  std::vector<std::string> exchanged = {};  // effect ids that came in the place of `removed`, beside `added`
  std::vector<std::string> where;
  std::vector<EffectTerm> terms;             // added, else removed
  std::string formula, variable;             // of a curve that was added
  std::vector<std::string> stands;           // numbers of it beyond four prior sigmas: it stands in for something else
  std::vector<std::string> background = {};  // effect ids that are there a little at each joint since (background.h)
  std::optional<double> likely;  // its probability, where the evidence alone is less than a name is asked for
  ErrorSummary fitted, held_out, held_out_region, held_out_session;
  std::optional<double> noise;           // of a coordinate, px or m
  std::optional<double> rms_of_noise_m;  // FitReport
};

/// A step that was tried and not taken.
struct RefusedStep {
  std::string id;
  std::vector<std::string> where;
  Message reason;
};

struct ImprovementOptions {
  std::vector<EffectTerm> effects;    // in the model, held
  std::vector<EffectTerm> estimated;  // in the model from the start, estimated; never removed
  std::set<std::string> likely;       // names among them that need no more evidence than to be likely
  int most_steps = 24;
  int most_models = 80;  // the budget: no change is begun once so many models were fitted and held out
  /// Curves without a name are taken in beside the names; without them, names that leave a curve on top are taken back.
  bool with_curves = true;
  bool is_thorough = false;   // other ends are sought as long as most_models last, which takes minutes (regrowing.h)
  bool with_choosing = true;  // Improvement::held_out_choosing
  bool with_held_out = true;  // of the candidates that every diagnosis fits, too; improve() goes without
  /// After every diagnosis and before every change; returning false stops with what there is.
  std::function<bool(const ImprovementStep& latest)> on_step;
  std::function<bool(double done)> on_progress;  // as in DiagnosisOptions
  std::function<bool(int iteration, double cost, const Unknowns&)> on_iteration;
};

/// What a change of a model comes to.
struct ModelChange {
  std::optional<Diagnosis> model;      // afterwards; none where nothing was taken, or nothing until it was stopped
  std::vector<ImprovementStep> steps;  // the addition, then what it made superfluous
  std::vector<RefusedStep> refused;
  int models = 0;  // that were fitted and held out on the way
  bool stopped = false;
};

struct Improvement {
  std::vector<ImprovementStep> steps;
  std::vector<RefusedStep> refused;
  Diagnosis last;                                  // of the last model: what is left; never missing_effect or ambiguous
  std::vector<BillRow> bill;                       // of the last model
  InclusionProbabilities inclusion_probabilities;  // of the last model's names
  /// Of what was in excess of the noise at the start: what has names, and what curves without a name explain.
  std::optional<double> named_share, unnamed_share;
  /// Of few observations, of which a model with causes was chosen: the error where each part takes no part in choosing
  /// either (choosing.h). What is held out otherwise has had its say in what the model holds.
  std::optional<ErrorSummary> held_out_choosing;
  /// The last step as it was before the robot's own error from pose to pose was weighed beside the noise: then less is
  /// left in the images, of an answer that is less likely. Absent where there is no such error.
  std::optional<ImprovementStep> unweighed;
  int models = 0;                // that were fitted and held out
  int most_models = 0;           // ImprovementOptions::most_models
  bool is_budget_spent = false;  // then more may be missing than was looked for
  bool stopped = false;
};

/// Effect ids that only one of two models has.
struct ChangedNames {
  std::vector<std::string> gone, come;
};
ChangedNames changed_names(const std::vector<EffectTerm>& before, const std::vector<EffectTerm>& after);

/// The first step of an improvement: nothing added.
ImprovementStep find_step(const Diagnosis& model);

}  // namespace handsight
