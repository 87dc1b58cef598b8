// SPDX-License-Identifier: Apache-2.0
// A fit as the calibration that is exported.
#pragma once

#include <string>

#include "estimation/fit_report.h"
#include "session/calibration.h"

namespace handsight {

/// `options` must be those of the fit; `software` is its name and version. Created now.
Calibration calibration_of(const Session& session, const Fit& fit, const FitReport& told, const FitOptions& options,
                           const std::string& software);

}  // namespace handsight
