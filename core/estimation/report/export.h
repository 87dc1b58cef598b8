// SPDX-License-Identifier: Apache-2.0
// A fit as the calibration that is exported.
#pragma once

#include <string>

#include "estimation/report/doubt.h"
#include "estimation/report/fit_report.h"
#include "session/calibration.h"

namespace handsight {

/// `options` must be those of the fit, and `doubt` of its effects; `software` is its name and version. Created now. Of
/// sessions that are fitted together that of each, and of the first beside; what is doubted is then left out.
Calibration calibration_of(const Session& session, const Fit& fit, const FitReport& told, const FitOptions& options,
                           const std::string& software, const Doubt& doubt = {});

/// Tells in a calibration what is doubted of its effects, `terms` of the fit; in the place of what it told before.
void set_doubt(const Robot& robot, const std::vector<EffectTerm>& terms, const Doubt& doubt, Calibration& calibration);

}  // namespace handsight
