// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/weighing.h"

#include <algorithm>

namespace handsight {

Weighing weighing(const Fit& fit) {
  constexpr int sure = 30;
  Weighing w;
  if (fit.noise_estimate && fit.noise_estimate->sigma > 0 && fit.noise_estimate->degrees >= sure) {
    w.noise = fit.noise_estimate->sigma;
  } else if (fit.noise && *fit.noise > 0) {
    w.noise = *fit.noise;
  } else {
    w.knowledge = {false, static_cast<double>(std::max(fit.rows - fit.unknowns, 1))};
    w.noise = std::max(fit.residual_rms, 1e-12);
  }
  return w;
}

}  // namespace handsight
