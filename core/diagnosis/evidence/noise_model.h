// SPDX-License-Identifier: Apache-2.0
// What is known of the noise of a fit's rows, and the noise that weighs them.
#pragma once

#include "diagnosis/evidence/evidence.h"
#include "estimation/fit/fit.h"

namespace handsight {

/// `noise` of one coordinate (px or m): the robot-free estimate where it is sure (30 degrees of freedom), else what the
/// session declares. Where neither is known the residuals stand in for it, and `knowledge` says so.
struct NoiseModel {
  NoiseKnowledge knowledge;
  double noise = 1;
  double residual = 0;  // px or m, root mean square of what the fit leaves
};

NoiseModel noise_model(const Fit& fit);

/// Unknowns that the body's motions tell: a shape that is not known is determined by the rows beside them.
int unknowns_of_motions(const Fit& fit);

/// Makes fits as exact as any Bayes factor shows, and no more.
void set_quick(const NoiseModel& noise_model, FitOptions& options);

}  // namespace handsight
