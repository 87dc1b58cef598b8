// SPDX-License-Identifier: Apache-2.0
// Does the model leave more than noise of what an effect could explain?
#pragma once

#include "estimation/fit/fit.h"
#include "estimation/fit/noise.h"

namespace handsight {

/// Of what any effect could explain: internal residuals that the noise was estimated from are not part of it. Nothing
/// where the noise is not known or no degree of freedom is left.
std::optional<NoiseTest> lack_of_fit(const Fit& fit);

}  // namespace handsight
