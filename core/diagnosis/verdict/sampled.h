// SPDX-License-Identifier: Apache-2.0
// A few thousand observations, evenly over the session, decide what a hundred thousand would; the others check them.
#pragma once

#include "diagnosis/verdict/diagnosis_result.h"
#include "session/sample.h"

namespace handsight {

/// The sample that a diagnosis goes by; nothing where the session is short enough to be taken whole.
std::optional<Sample> sample_to_judge(const Session& session);

/// Tries a diagnosis of the sample on the observations that were not taken, and says so in its reason.
void check_on_the_others(const Session& session, const Sample& sample, Diagnosis& diagnosis);

}  // namespace handsight
