// SPDX-License-Identifier: Apache-2.0
/// @file
/// What a model lacks: which effects of the catalogue would explain what it leaves, by their Bayes factors.
#pragma once

#include "diagnosis/verdict/diagnosis.h"
#include "handsight/fit.h"

namespace handsight {

/// Compares a model with the measurements. Diagnosis::verdict says whether something is missing,
/// Diagnosis::candidates what it may be, best first. What the options say of effects is not read: the model says it.
/// Takes seconds; DiagnosisOptions::on_progress hears how far it is and can stop it.
/// Throws InputError as fit().
Diagnosis diagnose(const Session& session, const Model& model, const DiagnosisOptions& options = {});

/// The model with a candidate of its diagnosis in it, estimated from the candidate's values on.
/// Throws InputError for a candidate without a name whose curve could not be written down.
Model with_candidate(const Model& model, const DiagnosisCandidate& candidate, const Session& session);

}  // namespace handsight
