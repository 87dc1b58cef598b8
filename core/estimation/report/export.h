// SPDX-License-Identifier: Apache-2.0
// A fit as the calibration that is exported.
#pragma once

#include <string>

#include "estimation/report/fit_report.h"
#include "estimation/report/model_uncertainty.h"
#include "session/calibration.h"

namespace handsight {

/// `options` must be those of the fit, and `doubt` of its effects; `software` is its name and version. Created now. Of
/// sessions that are fitted together that of each, and of the first beside; what is doubted is then left out.
Calibration make_calibration(const Session& session, const Fit& fit, const FitReport& reported,
                             const FitOptions& options, const std::string& software,
                             const ModelUncertainty& model_uncertainty = {});

/// Tells in a calibration what is doubted of its effects, `terms` of the fit; in the place of what it told before.
void set_model_uncertainty(const Robot& robot, const std::vector<EffectTerm>& terms,
                           const ModelUncertainty& model_uncertainty, Calibration& calibration);

}  // namespace handsight
