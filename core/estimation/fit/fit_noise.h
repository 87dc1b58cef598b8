// SPDX-License-Identifier: Apache-2.0
// The noise that a fit goes by: declared, seen in the measurements, or neither.
#pragma once

#include "estimation/fit/fit_result.h"
#include "session/session.h"

namespace handsight {

/// Of one coordinate (px, m), as the session has it.
const std::optional<double>& declared_noise(const Session& session);

/// Of one coordinate (px, m): no sensor on a robot measures finer.
double finest_noise(const Session& session);

/// Points that stand against each other better than any sensor measures (1e-3 px, 1 um) or to the last decimal that
/// they are written with, and a hundred times better than the model meets them: a tracker's virtual points, computed
/// from one pose. Their scatter says nothing of the noise.
bool are_rigid_by_construction(const Problem& images, const Unknowns& unknowns, const NoiseEstimate& estimate);

/// What the priors of effects are weighed against, into Problem::noise: the noise, or where nothing is known of it
/// 0.3 px (1 mm).
void set_prior_noise(const Session& session, const Unknowns& start, Problem& images);

/// What a robust loss's bend is measured in: the noise of one coordinate as this objective has it, in px, or in m where
/// points are fitted (for triangulated ones the mean of theirs). Where nothing tells it, the median residual of a plain
/// fit. 1 where no loss is asked for.
double loss_noise(const Session& session, const Problem& images, const Problem& fitted, const Unknowns& start,
                  const FitOptions& options);

/// The noise of one coordinate (px, m) before there is a fit: declared, else seen; nothing where neither tells it.
std::optional<double> noise_at_start(const Session& session, const Problem& images, const Unknowns& start);

/// Noise and its estimate of a fit at its solution, with what is to be said of them. Where the sensor alone shows less
/// than finest_noise() and no more is left, that is the noise.
void set_noise(const Session& session, const Problem& images, Fit& fit);

}  // namespace handsight
