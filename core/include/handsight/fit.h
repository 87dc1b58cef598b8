// SPDX-License-Identifier: Apache-2.0
/// @file
/// Fitting a model to a session: where the observed body (or the sensor) sits, how its markers lie, the values of the
/// model's effects, and the covariance of all of it.
#pragma once

#include "estimation/fit/fit.h"
#include "estimation/report/fit_report.h"
#include "handsight/model.h"

namespace handsight {

/// The fit of a model. What the options say of effects is not read: the model says it.
/// Fit::covariance is 6 x 6, of a small motion (x y z in m, rx ry rz in rad, TCP axes) before Fit::tcp_from_body.
/// Throws InputError where nothing can be fitted: no observation that is used, or a mount that nothing determines.
Fit fit(const Session& session, const Model& model, const FitOptions& options = {});

/// Residuals of every observation, what was not used and why, and the error on observations that the fit has not seen
/// (five folds). `model` and `options` are those of the fit. Errors in px (root mean square over image coordinates) or
/// m (over the lengths of three coordinates together).
FitReport report(const Session& session, const Fit& fit, const Model& model, const FitOptions& options = {});

/// The model with the values that the fit has found. An effect counts as estimated where the fit moved one of its
/// numbers.
Model make_model(const Fit& fit);

}  // namespace handsight
