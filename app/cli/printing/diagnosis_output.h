// SPDX-License-Identifier: Apache-2.0
// A diagnosis and an improvement for people and as JSON.
#pragma once

#include "command.h"
#include "diagnosis/outliers/flipped_targets.h"
#include "diagnosis/selection/improvement.h"

namespace handsight::cli {

void print_diagnosis(const Output& output, const Session& session, const Diagnosis& diagnosis);
/// The points that a fit leaves out.
Json lone_json(const std::vector<LoneObservation>& lone);
Json flipped_json(const std::vector<FlippedTarget>& flipped);
Json wrong_points_json(const std::vector<WrongPoint>& wrong, const Session& session);
Json diagnosis_json(const Session& session, const Diagnosis& diagnosis);

void print_improvement(const Output& output, const Session& session, const Improvement& improvement);
Json improvement_json(const Session& session, const Improvement& improvement);

/// Effects as users name them: those with values are held, the others estimated; where one has a choice (an observation
/// from which on it acts), the one that suits the session best.
void add_effects(const std::vector<std::string>& texts, const Session& session, std::vector<EffectTerm>& held,
                 std::vector<EffectTerm>& estimated);

}  // namespace handsight::cli
