// SPDX-License-Identifier: Apache-2.0
// What a candidate is worth beside small deviations at each joint, which every robot has: a large cause alone leaves
// them, and many numbers that take them in seem likelier for it.
#pragma once

#include <functional>
#include <vector>

#include "diagnosis/ranking/refitting.h"

namespace handsight {

/// What small deviations at each joint (zeros, geometry, springs, eccentricities, of the likeliest sizes) add to ln of
/// the evidence of a fit with a candidate's terms, what these sizes cost to choose included; 0 where they add nothing
/// or do not stay small. Beside all of its terms, or those alone that are larger than usual: the others may be small
/// deviations themselves. `refit` fits terms in the place of the candidate's, as that was fitted.
double gain_by_small_deviations(const Refit& candidate,
                                const std::function<Refit(const std::vector<EffectTerm>&)>& refit);

}  // namespace handsight
