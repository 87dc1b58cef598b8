// SPDX-License-Identifier: Apache-2.0
// Add what is missing, refit, look again, until the model is adequate or nothing that is known helps.
#pragma once

#include <set>

#include "diagnosis/selection/certainty.h"
#include "diagnosis/verdict/diagnosis.h"

namespace handsight {

/// A model on the way: the first as it was, then one per change.
struct ImprovementStep {
  std::string added;    // effect id; empty for the first, and where all names were sought again
  std::string removed;  // effect ids, where something added before is no longer needed, or stood in for another
  std::vector<std::string> exchanged = {};  // effect ids that came in the place of `removed`, beside `added`
  std::vector<std::string> where;
  std::vector<EffectTerm> terms;    // added, else removed
  std::string formula, variable;    // of a curve that was added
  std::vector<std::string> stands;  // numbers of it beyond four plausible sizes: it stands in for something else
  std::optional<double> likely;     // its probability, where the evidence alone is less than a name is asked for
  ErrorSummary fitted, held_out;
  std::optional<double> noise;  // px or m
};

/// A step that was tried and not taken.
struct RefusedStep {
  std::string id;
  std::vector<std::string> where;
  std::string reason;
};

struct ImprovementOptions {
  std::vector<EffectTerm> effects;    // in the model, held
  std::vector<EffectTerm> estimated;  // in the model from the start, estimated; never removed
  std::set<std::string> likely;       // names among them that need no more evidence than to be likely
  int most_steps = 24;
  /// Curves without a name are taken in beside the names; without them, names that leave a curve on top are taken back.
  bool with_curves = true;
  bool with_held_out = true;  // of the candidates that every diagnosis fits, too; improve() goes without
  /// After every diagnosis and before every change; returning false stops with what there is.
  std::function<bool(const ImprovementStep& latest)> on_step;
  std::function<bool(double done)> on_progress;  // as in DiagnosisOptions
  std::function<bool(int iteration, double cost, const Unknowns&)> on_iteration;
};

/// What a change of a model comes to.
struct ModelChange {
  std::optional<Diagnosis> model;      // afterwards; none where nothing was taken, or it was stopped
  std::vector<ImprovementStep> steps;  // the addition, then what it made superfluous
  std::vector<RefusedStep> refused;
  bool stopped = false;
};

/// The model as it stands (ImprovementOptions::effects and estimated) and what is said of it.
Diagnosis diagnosed(const Session& session, const ImprovementOptions& options);
/// The first step of an improvement: nothing added.
ImprovementStep step_of(const Diagnosis& model);

/// Adds one candidate of model.candidates: fitted in full, diagnosed again, taken where the held-out error falls; then
/// whatever was added before and is no longer worth its parameters is taken out, and what only stood in for another
/// effect is exchanged for it.
ModelChange add_candidate(const Session& session, const ImprovementOptions& options, const Diagnosis& model,
                          const DiagnosisCandidate& candidate);
/// The first of the candidates that pass the threshold and are not refused.
ModelChange add_best(const Session& session, const ImprovementOptions& options, const Diagnosis& model);

/// Once nothing is left to add: other names, and other places of the same, for what stands, where they are clearly
/// likelier and the held-out error does not rise beyond its third digit (other_names.h).
ModelChange seek_other_names(const Session& session, const ImprovementOptions& options, const Diagnosis& model);
/// How often that is done; what it drops may pass again.
inline constexpr int most_times_sought = 4;

/// Where nothing else is to be found: the likeliest name that is not in a model with names, where the held-out error
/// falls with it (Barbieri and Berger 2004: for predictions the model of what is likely, not the likeliest model).
/// `certainty`: of the model.
ModelChange add_likely(const Session& session, const ImprovementOptions& options, const Diagnosis& model,
                       const Certainty& certainty);

/// An unnamed curve passes and leads: the names that were added so far have not explained what is missing.
bool is_outdone(const Diagnosis& model);

/// What one effect or curve of the last model does.
struct Worth {
  std::string id;
  std::vector<std::string> where;
  bool unnamed = false;
  std::string text;   // of a curve: what it follows
  double hand_m = 0;  // root mean square over the observations of how far it moves the body's origin
};

struct Improvement {
  std::vector<ImprovementStep> steps;
  std::vector<RefusedStep> refused;
  Diagnosis last;  // of the last model: what is left; never missing_effect or ambiguous
  std::vector<Worth> worth;
  Certainty certainty;  // of the last model's names
  /// Of what was in excess of the noise at the start: what has names, and what curves without a name explain.
  std::optional<double> named_share, unnamed_share;
  bool stopped = false;
};

/// add_best until nothing is left to add, names and curves by their evidence beside each other: what the others make
/// needless goes, curves are looked for again after every change, and in the end other names for all.
Improvement improve(const Session& session, const ImprovementOptions& options = {});

}  // namespace handsight
