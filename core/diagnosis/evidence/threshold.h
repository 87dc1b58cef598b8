// SPDX-License-Identifier: Apache-2.0
// Which evidence counts: by simulating nothing missing on the session's own poses.
#pragma once

#include "diagnosis/evidence/candidates.h"
#include "diagnosis/evidence/evidence.h"

namespace handsight {

/// What is asked for more where there is scatter: draws do not show how much it can hide or feign.
inline constexpr double more_with_repeatability = 2.5;

/// The ln of a Bayes factor that the best of all candidates exceeds in one of 200 sessions like this one with nothing
/// missing, from 400 draws of the scores that noise alone gives (the tail of the largest taken as exponential); not
/// below 4. Where there is scatter, which has to be estimated too, more_with_repeatability beyond it.
double simulated_threshold(const LinearModel& model, const Candidates& candidates, const Repeatability& repeatability,
                           const NoiseKnowledge& knowledge);

}  // namespace handsight
