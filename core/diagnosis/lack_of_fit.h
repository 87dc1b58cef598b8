// SPDX-License-Identifier: Apache-2.0
// Does the model leave more than noise of what an effect could explain?
#pragma once

#include <optional>

#include "estimation/fit.h"

namespace handsight {

/// Chi-squared of what any effect could explain, its degrees of freedom, its p-value.
struct LackOfFit {
  double chi2 = 0;
  double degrees = 0;
  double p = 1;
  double excess() const { return chi2 - degrees; }
};

/// Nothing where the noise is not known or no degree of freedom is left.
std::optional<LackOfFit> lack_of_fit(const Fit& fit);

}  // namespace handsight
