// SPDX-License-Identifier: Apache-2.0
// What a diagnosis says of one candidate, from its place in the ranking and from its full fit.
#pragma once

#include <string>

#include "diagnosis/ranking/refitting.h"
#include "diagnosis/verdict/diagnosis_result.h"

namespace handsight {

DiagnosisCandidate make_candidate(const RankedEffect& ranked, const Diagnosis& model, const NoiseModel& noise_model,
                                  const Session& session);
DiagnosisCandidate make_candidate(const RankedEmpiricalError& ranked, const Session& session);

/// The numbers of the full fit in place of the linear ones. `ln_ways`: ln of the choices in which the candidate could
/// have been another.
void take_refit(const Refit& refit, double ln_ways, const Diagnosis& model, const NoiseModel& noise_model,
                const Session& session, DiagnosisCandidate& candidate);

}  // namespace handsight
