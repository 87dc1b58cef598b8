// SPDX-License-Identifier: Apache-2.0
// Which evidence counts: by simulating nothing missing on the session's own poses.
#pragma once

#include "diagnosis/candidates.h"
#include "diagnosis/evidence.h"

namespace handsight {

/// The ln of a Bayes factor that the best of all candidates exceeds in one of 200 sessions like this one with nothing
/// missing; not below 3 (odds of 20).
double simulated_threshold(const LinearModel& model, const Candidates& candidates, double scatter,
                           const NoiseKnowledge& knowledge);

}  // namespace handsight
