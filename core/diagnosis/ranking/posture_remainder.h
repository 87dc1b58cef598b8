// SPDX-License-Identifier: Apache-2.0
// A smooth remainder over the robot's postures, that no name has: what it may explain is not time's doing.
#pragma once

#include "diagnosis/evidence/noise_model.h"

namespace handsight {

/// ln of the Bayes factor of these terms against the model of `without` where the hand's place may also be off by a
/// smooth function of the posture: a Gaussian process of low rank (Kennedy and O'Hagan 2001; random waves, Rahimi and
/// Recht 2007) whose size and length are the likeliest, with the terms and without them. Linear, about the fit.
double ln_factor_beside_posture(const Fit& without, const std::vector<EffectTerm>& terms,
                                const Repeatability& repeatability, const NoiseModel& noise_model);

}  // namespace handsight
