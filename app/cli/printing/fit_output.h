// SPDX-License-Identifier: Apache-2.0
// A fit for people, as JSON, and as a calibration.
#pragma once

#include "command.h"
#include "estimation/report/fit_report.h"

namespace handsight::cli {

void print_fit(const Output& output, const Session& session, const Fit& fit, const FitReport& told,
               const FitOptions& options);
Json fit_json(const Session& session, const Fit& fit, const FitReport& told, const FitOptions& options);

}  // namespace handsight::cli
