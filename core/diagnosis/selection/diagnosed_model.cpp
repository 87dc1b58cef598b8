// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/selection/diagnosed_model.h"

#include "diagnosis/selection/elsewhere.h"
#include "diagnosis/verdict/diagnosis.h"

namespace handsight {

DiagnosisOptions diagnosis_options(const ImprovementOptions& options, const std::vector<EffectTerm>& estimated,
                                   const std::optional<Unknowns>& start, const std::optional<double>& most) {
  DiagnosisOptions o;
  o.most_held_out = most;
  o.effects = options.effects;
  o.estimated = estimated;
  o.start = start;
  o.with_curves = options.with_curves;
  o.with_held_out = options.with_held_out;
  o.with_regions = false;  // worked out where a change is judged by them
  o.on_progress = options.on_progress;
  o.on_iteration = options.on_iteration;
  return o;
}

Diagnosis diagnosed_from(const Session& session, const ImprovementOptions& options,
                         const std::vector<EffectTerm>& estimated, const std::optional<Unknowns>& start,
                         const std::optional<double>& most) {
  return diagnose(session, diagnosis_options(options, estimated, start, most));
}

Diagnosis model_from(const Session& session, const ImprovementOptions& options,
                     const std::vector<EffectTerm>& estimated, const std::optional<Unknowns>& start,
                     const std::optional<double>& most) {
  DiagnosisOptions o = diagnosis_options(options, estimated, start, most);
  o.only_model = true;
  return diagnose(session, o);
}

Diagnosis diagnosed_on(const Session& session, const ImprovementOptions& options, Diagnosis model) {
  return diagnose_model(session, diagnosis_options(options), std::move(model));
}

std::optional<Diagnosis> in_the_place_of(const Diagnosis& model, const Session& session,
                                         const ImprovementOptions& options, const std::vector<EffectTerm>& estimated,
                                         const std::optional<Unknowns>& start, double most) {
  Diagnosis next = model_from(session, options, estimated, start, most);
  if (next.stopped) return next;
  if (held_out_error(next) > most || !worse_elsewhere(model, next).empty()) return std::nullopt;
  next = diagnosed_on(session, options, std::move(next));
  if (!next.stopped) set_errors_elsewhere(next);
  return next;
}

}  // namespace handsight
