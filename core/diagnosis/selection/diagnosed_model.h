// SPDX-License-Identifier: Apache-2.0
// A model with other terms than the present one, and what is said of it.
#pragma once

#include <optional>
#include <vector>

#include "diagnosis/selection/improvement_result.h"
#include "diagnosis/verdict/diagnosis_options.h"

namespace handsight {

/// What an improvement asks of every diagnosis; its own model where no terms are given.
DiagnosisOptions diagnosis_options(const ImprovementOptions& options, const std::vector<EffectTerm>& estimated = {},
                                   const std::optional<Unknowns>& start = {}, const std::optional<double>& most = {});

/// A model with these estimated terms, diagnosed unless its held-out error is above `most` (DiagnosisOptions).
Diagnosis diagnosed_from(const Session& session, const ImprovementOptions& options,
                         const std::vector<EffectTerm>& estimated, const std::optional<Unknowns>& start,
                         const std::optional<double>& most = std::nullopt);

/// The same, but what is missing is not asked (diagnosis.h, only_model), which is most of the work: of models that may
/// not stay. diagnosed_on goes on with one that does.
Diagnosis model_from(const Session& session, const ImprovementOptions& options,
                     const std::vector<EffectTerm>& estimated, const std::optional<Unknowns>& start,
                     const std::optional<double>& most = std::nullopt);
Diagnosis diagnosed_on(const Session& session, const ImprovementOptions& options, Diagnosis model);

/// A model with these estimated terms in the place of `model`, diagnosed: none where its held-out error is above
/// `most`, or elsewhere clearly larger. One that was stopped says so.
std::optional<Diagnosis> in_the_place_of(const Diagnosis& model, const Session& session,
                                         const ImprovementOptions& options, const std::vector<EffectTerm>& estimated,
                                         const std::optional<Unknowns>& start, double most);

}  // namespace handsight
