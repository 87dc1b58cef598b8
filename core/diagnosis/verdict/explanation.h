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

/// An error as it is told, the root mean square (as_told), with its unit and the
/// three digits of tables: "0.243 px", "3.12 mm".
std::string error_text(const ErrorSummary& error);

/// The same as sentences tell it, to two digits: "0.20 px". told_size: from px or m.
std::string told_error(const ErrorSummary& error);
std::string told_size(double error, bool in_pixels);

}  // namespace handsight
