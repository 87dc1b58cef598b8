// SPDX-License-Identifier: Apache-2.0
// Compare the model with the measurements, see where it fails, learn what is missing.
#pragma once

#include "diagnosis/verdict/diagnosis_options.h"
#include "diagnosis/verdict/diagnosis_result.h"

namespace handsight {

/// Of more than 4000 used observations a sample of 3000 decides (SampleCheck); DiagnosisOptions::fitted is then not
/// read.
Diagnosis diagnose(const Session& session, const DiagnosisOptions& options = {});

/// What is missing of a model that was diagnosed with DiagnosisOptions::only_model and these options. Not of a sample.
Diagnosis diagnose_model(const Session& session, const DiagnosisOptions& options, Diagnosis model);

/// Diagnosis::threshold of such a model alone.
double threshold_of(const Session& session, const DiagnosisOptions& options, const Diagnosis& model);

}  // namespace handsight
