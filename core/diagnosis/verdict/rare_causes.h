// SPDX-License-Identifier: Apache-2.0
// Slips, drifts and changes between sessions are rare: what their evidence has to overcome before they are named.
#pragma once

#include "diagnosis/verdict/diagnosis_result.h"

namespace handsight {

/// Poses seldom come in random order, so what follows the posture passes for a slip or a drift: one that does not pass
/// beside a smooth remainder over the postures too (posture_remainder.h) has its evidence there, no more. What would
/// pass but for that, or but for the odds against it, says so (DiagnosisCandidate::held_back). After the full fits.
void hold_back_rare_causes(Diagnosis& diagnosis);

}  // namespace handsight
