// SPDX-License-Identifier: Apache-2.0
// Limits that a certificate promises, and how often they held.
#pragma once

#include "geometry/rigid.h"

namespace handsight {

/// The length that a normal error of this covariance (m^2) stays below with this probability: the weighted sum of
/// chi-squareds is taken as one with the same mean and variance (Satterthwaite), which errs by less than 3 % at 0.95.
double length_limit(const Matrix3& covariance, double probability);

/// The interval of Clopper and Pearson (1934) for a share of which `inside` of `all` were seen.
struct ShareInterval {
  double low = 0, high = 1;
};
ShareInterval clopper_pearson(int inside, int all, double confidence);

}  // namespace handsight
