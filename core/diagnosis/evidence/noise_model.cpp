// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/evidence/noise_model.h"

#include <algorithm>

namespace handsight {

NoiseModel noise_model(const Fit& fit) {
  constexpr int sure = 30;
  NoiseModel w;
  w.residual = fit.residual_rms;
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

void set_quick(const NoiseModel& noise_model, FitOptions& options) {
  options.smallest_step = 1e-7;
  const double usual = std::max(noise_model.noise, noise_model.residual);  // of a residual, as Bayes factors weigh it
  options.least_gain = 1e-2 * usual * usual;
  options.reuse_below = 1e-3;
  options.most_iterations = 40;
}

}  // namespace handsight
