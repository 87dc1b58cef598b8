// SPDX-License-Identifier: Apache-2.0
// What a fit leaves, in the figure that its report begins with.
#pragma once

#include "estimation/fit/fit.h"

namespace handsight {

/// With cameras px, r.m.s. of a coordinate; with a tracker, poses or touches m, the mean distance (mean_m of
/// ErrorSummary). `fit` is of the session.
double reported_error(const Session& session, const Fit& fit);

}  // namespace handsight
