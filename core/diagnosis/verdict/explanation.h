// SPDX-License-Identifier: Apache-2.0
// What a diagnosis says, in words that a robot engineer would use.
#pragma once

#include "base/message.h"
#include "diagnosis/verdict/diagnosis_result.h"

namespace handsight {

/// What the candidate is, what speaks for it, and a cheap check with the real robot.
Message explain(const DiagnosisCandidate& candidate, const Diagnosis& diagnosis, const Session& session);

Message too_few_text(int observations, int degrees, int unknowns);
Message missing_text(const DiagnosisCandidate& best, bool has_rival, const Diagnosis& diagnosis);
Message too_little_text(const DiagnosisCandidate& best, const Diagnosis& diagnosis);
Message follows_unnamed_text(const DiagnosisCandidate& unnamed, const Session& session);
Message follows_pattern_text(const DiagnosisPattern& pattern);
/// Nothing that was measured explains it, and it is more than robots scatter.
Message poor_repeatability_text(const Diagnosis& d);

Message adequate_text(const Diagnosis& diagnosis, bool has_repeatability);
Message unknown_noise_text(const Diagnosis& diagnosis);

/// "arm_2 and arm_4"
Message listed(const std::vector<std::string>& names);
/// Joints as the robot's file calls them, markers and observations in words that are translated.
Message listed_places(const std::vector<std::string>& where);

/// An error as it is reported, the root mean square (as_reported), with its unit and the
/// three digits of tables: "0.243 px", "3.12 mm".
Message error_text(const ErrorSummary& error);

/// The same as sentences tell it, to two digits: "0.20 px". reported_size: from px or m.
Message reported_error(const ErrorSummary& error);
Message reported_size(double error, bool in_pixels);

}  // namespace handsight
