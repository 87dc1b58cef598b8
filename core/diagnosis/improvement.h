// SPDX-License-Identifier: Apache-2.0
// Add what is missing, refit, look again, until the model is adequate or nothing that is known helps.
#pragma once

#include "diagnosis/diagnosis.h"

namespace handsight {

/// A model on the way: the first as it was, then one per change.
struct ImprovementStep {
  std::string added;    // effect id; empty for the first
  std::string removed;  // effect id, where something added before is no longer needed
  std::vector<std::string> where;
  std::vector<EffectTerm> terms;  // added or removed
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
  int most_steps = 16;
  /// After every diagnosis and before every change; returning false stops with what there is.
  std::function<bool(const ImprovementStep& latest)> on_step;
  std::function<bool(double done)> on_progress;  // within a diagnosis
  /// Every iteration of every fit: cost and unknowns; returning false stops.
  std::function<bool(int iteration, double cost, const Unknowns&)> on_iteration;
};

struct Improvement {
  std::vector<ImprovementStep> steps;
  std::vector<RefusedStep> refused;
  Diagnosis last;  // of the last model: what is left
  bool stopped = false;
};

Improvement improve(const Session& session, const ImprovementOptions& options = {});

}  // namespace handsight
