// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/evidence/noise_model.h"

#include <algorithm>

#include "chain/sighting.h"

namespace handsight {

int unknowns_of_motions(const Fit& fit) {
  const int of_shape = fit.problem.shape ? 0 : std::max(3 * fit.problem.marker_count - 6, 0);
  return std::max(fit.unknowns - of_shape, 0);
}

namespace {

/// Degrees of freedom where the noise is not known: of a tracker's points that are rigid by construction (were they
/// not, they would tell the noise) no observation says more than where the body is.
int degrees_left(const Fit& fit) {
  constexpr int of_a_motion = 6;
  if (fit.problem.rig || fit.problem.marker_count < 3) return std::max(fit.rows - fit.unknowns, 1);
  int rows = 0;
  bool has_more = false;
  for (const ProblemObservation& o : fit.problem.observations) {
    int of_observation = 0;
    for (const Sighting& s : o.sightings) of_observation += row_count(s);
    has_more = has_more || of_observation > of_a_motion;
    rows += std::min(of_observation, of_a_motion);
  }
  return std::max(has_more ? rows - unknowns_of_motions(fit) : fit.rows - fit.unknowns, 1);
}

}  // namespace

NoiseModel noise_model(const Fit& fit) {
  constexpr int sure = 30;
  NoiseModel w;
  w.residual = fit.residual_rms;
  if (fit.noise_estimate && fit.noise_estimate->sigma > 0 && fit.noise_estimate->degrees >= sure) {
    w.noise = fit.noise_estimate->sigma;
  } else if (fit.noise && *fit.noise > 0) {
    w.noise = *fit.noise;
  } else {
    w.knowledge = {false, static_cast<double>(degrees_left(fit))};
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
