// SPDX-License-Identifier: Apache-2.0
// How each of the three objectives is brought to its minimum, on all observations or on a part of them.
#pragma once

#include "estimation/fit/fit_result.h"
#include "session/session.h"

namespace handsight {

/// Sets `fit`'s solution (for the angle-axis objective its covariance and weights too) from its problem; `images` is
/// the problem with the sightings as measured, `noise` that of one coordinate (px, m), which the angle-axis objective
/// reads; losses bend at Fit::loss_noise. Throws InputError where markers
/// are to be held and no observation shows three of them as points.
void minimise(const Session& session, const Problem& images, const Unknowns& start, const FitOptions& options,
              double noise, Fit& fit);

/// The unknowns of the same fit on other observations (a fold of a cross-validation), starting from `fit`'s own. A held
/// shape is the average of these observations.
Unknowns refit(const Fit& fit, const FitOptions& options, const Problem& part, double noise);

/// J^T Sigma J of the 3D objective with the covariances of the triangulated points (per unit px^2).
Eigen::MatrixXd point_noise_middle(const Problem& points, const Unknowns& unknowns);

}  // namespace handsight
