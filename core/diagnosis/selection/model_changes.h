// SPDX-License-Identifier: Apache-2.0
// The changes that an improvement makes of a model, one by one: an addition, other names, a likely name.
#pragma once

#include "diagnosis/selection/improvement_result.h"
#include "diagnosis/selection/model_search.h"

namespace handsight {

/// The model as it stands (ImprovementOptions::effects and estimated) and what is said of it.
Diagnosis diagnosed(const Session& session, const ImprovementOptions& options);

/// Adds one candidate of model.candidates: fitted in full, diagnosed again, taken where the held-out error falls; then
/// whatever was added before and is no longer worth its parameters is taken out, and what only stood in for another
/// effect is exchanged for it.
ModelChange add_candidate(const Session& session, const ImprovementOptions& options, const Diagnosis& model,
                          const DiagnosisCandidate& candidate);
/// What may be added to a model, in the order in which it is tried: by evidence, but first what comes before the best.
/// Empty where nothing is missing, or nobody can say. The pointers are into `model`.
std::vector<const DiagnosisCandidate*> candidates_to_try(const Diagnosis& model, bool with_curves);
/// The first of those that is not refused.
ModelChange add_best(const Session& session, const ImprovementOptions& options, const Diagnosis& model);

/// An alternative in the place of the model, where the held-out error does not rise beyond its third digit, nor
/// elsewhere; as a step of its own.
void put_in_place(const Session& session, const ImprovementOptions& options, const Diagnosis& model,
                  const ModelAlternative& other, ModelChange& change);

/// Once nothing is left to add: other names, and other places of the same, for what stands, where they are clearly
/// likelier and the held-out error does not rise beyond its third digit (search_models.h).
ModelChange search_models(const Session& session, const ImprovementOptions& options, const Diagnosis& model);
/// How often that is done; what it drops may pass again.
inline constexpr int most_times_sought = 4;

/// Where nothing else is to be found: the likeliest name that is not in a model with names, where the held-out error
/// falls with it, or stays as it is to its third digit with one of 95 % and more (Barbieri and Berger 2004: for
/// predictions the model of what is likely, not the likeliest model). `inclusion_probabilities`: of the model.
ModelChange add_likely(const Session& session, const ImprovementOptions& options, const Diagnosis& model,
                       const InclusionProbabilities& inclusion_probabilities);

/// In the end: the likeliest choice of names in the place of a model that is another one, where full fits say so too,
/// and the held-out error does not rise beyond its third digit, nor elsewhere. `inclusion_probabilities`: of the model.
ModelChange take_likeliest(const Session& session, const ImprovementOptions& options, const Diagnosis& model,
                           const InclusionProbabilities& inclusion_probabilities);

/// An unnamed curve passes and leads: the names that were added so far have not explained what is missing.
bool is_outdone(const Diagnosis& model);

}  // namespace handsight
