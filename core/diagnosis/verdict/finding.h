// SPDX-License-Identifier: Apache-2.0
// What a diagnosis goes by, and whose fault the error is in its light.
#pragma once

#include "diagnosis/verdict/diagnosis_result.h"

namespace handsight {

/// The candidate that a diagnosis goes by: the first that passes the threshold, of a plausible size where there is such
/// a one; curves without a name count where they were fitted. Null: none passes.
const DiagnosisCandidate* finding_of(const Diagnosis& diagnosis);

/// Whose fault an error is, as far as residuals alone say, corrected by what was found: the share of the excess that
/// the finding explains belongs to what it moves (cameras and their mount, the marker body, the robot); the rest is
/// parted as before. A lens can look like the robot's error, for both images of a marker may still fit together.
Blame blame_by_finding(const Blame& blame, const Diagnosis& diagnosis);

}  // namespace handsight
