// SPDX-License-Identifier: Apache-2.0
// Add what is missing, refit, look again, until the model is adequate or nothing that is known helps.
#pragma once

#include "diagnosis/selection/improvement_result.h"

namespace handsight {

/// add_best until nothing is left to add, names and curves by their evidence beside each other: what the others make
/// needless goes, curves are looked for again after every change, and in the end other names for all.
Improvement improve(const Session& session, const ImprovementOptions& options = {});

/// From a model with names, however they came, to where improve() would end: what is left of its steps, and the ends
/// that are sought beside its own. No model where nothing better was found. Where it is stopped, what was found until
/// then.
ModelChange improve_on(const Session& session, const ImprovementOptions& options, const Diagnosis& model);

/// ImprovementOptions::most_models of an improvement that is thorough: minutes, of a thousand rows.
inline constexpr int most_models_of_thorough = 400;

}  // namespace handsight
