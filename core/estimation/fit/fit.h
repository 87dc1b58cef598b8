// SPDX-License-Identifier: Apache-2.0
// The fit: TCP->Body, markers and mount from the labelled observations, by one of the thesis's three objectives.
#pragma once

#include "estimation/fit/fit_options.h"
#include "estimation/fit/fit_result.h"
#include "session/session.h"

namespace handsight {

/// Throws InputError where nothing can be fitted: no used observation, or an unknown mount that nothing determines.
Fit fit(const Session& session, const FitOptions& options = {});

}  // namespace handsight
