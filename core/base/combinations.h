// SPDX-License-Identifier: Apache-2.0
// In how many ways something can be chosen.
#pragma once

#include <cmath>

namespace handsight {

/// ln of the ways to take k of n, 0 <= k <= n. Safe in any thread: std::lgamma, which leaves the sign of the gamma
/// function in a variable that all threads share, is not.
inline double ln_choose(double n, double k) {
  const auto ln_factorial = [](double x) {
    int sign = 1;
    return lgamma_r(x + 1, &sign);
  };
  return ln_factorial(n) - ln_factorial(k) - ln_factorial(n - k);
}

}  // namespace handsight
