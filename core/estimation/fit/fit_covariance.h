// SPDX-License-Identifier: Apache-2.0
// How sure a fit is: its covariances, and how many of its unknowns the measurements know.
#pragma once

#include "estimation/fit/fit_result.h"

namespace handsight {

/// Fewer observations cannot show how observations scatter: the scale of the residuals is used instead.
inline constexpr std::size_t fewest_for_repeatability = 10;

/// Sets rows, effective unknowns, residuals, chi-squared and the kind of the covariance, and answers with a factor f
/// (the problem's columns x any) of the covariance f f^T of the problem's columns. `images` is the problem with the
/// sightings as measured, at the solution; `declared` says whether the noise was. From the noise where the model agrees
/// with the measurements, else from the observations' scatter. With a loss its own: the inverse of its curvature about
/// the second moment of its score (Huber 1967), everything at the loss's weights. The angle-axis objective has set
/// Fit::parameter_covariance to its own before.
Eigen::MatrixXd covariance_factor(const Problem& images, const FitOptions& options, bool declared, Fit& fit);

/// Of touches: as many numbers were read as are asked for, and nothing says how exactly a touch tells. Then every sigma
/// stands for a length of which nothing is known (chain/unknown_angle.h).
bool is_accuracy_unknown(const Fit& fit);

/// A held shape has an error of its own: what of it the fit does not take up stays in the markers, as more columns of
/// the factor.
void add_shape_columns(const Fit& fit, Eigen::MatrixXd& factor);

}  // namespace handsight
