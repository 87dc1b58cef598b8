// SPDX-License-Identifier: Apache-2.0
// What a diagnosis says, in words that a robot engineer would use.
#pragma once

#include "diagnosis/verdict/diagnosis_result.h"

namespace handsight {

/// What the candidate is, what speaks for it, and a cheap check with the real robot.
std::string explain(const DiagnosisCandidate& candidate, const Diagnosis& diagnosis, const Session& session);

std::string too_few_text(int observations, int degrees, int unknowns);
std::string missing_text(const DiagnosisCandidate& best, bool has_rival, const Diagnosis& diagnosis);
std::string too_little_text(const DiagnosisCandidate& best, const Diagnosis& diagnosis);
std::string follows_unnamed_text(const DiagnosisCandidate& unnamed, const Session& session);
std::string follows_pattern_text(const DiagnosisPattern& pattern);
/// Nothing that was measured explains it, and it is more than robots scatter.
std::string too_much_scatter_text(const Diagnosis& d);

std::string adequate_text(const Diagnosis& diagnosis, bool has_scatter);
std::string unknown_noise_text(const Diagnosis& diagnosis);

/// "arm_2 and arm_4"
std::string listed(const std::vector<std::string>& names);

/// A length or pixel error with its unit: "0.24 px", "3.1 mm".
std::string error_text(const ErrorSummary& error);

}  // namespace handsight
