// SPDX-License-Identifier: Apache-2.0
// A fit for people, as JSON, and as a calibration.
#pragma once

#include <optional>
#include <string>

#include "command.h"
#include "estimation/report/fit_report.h"

namespace handsight::cli {

/// "2.695 mm": `value` times `scale`; "unknown" where there is none.
std::string text_or_unknown(const std::optional<double>& value, double scale, const char* unit);

void print_fit(const Output& output, const Session& session, const Fit& fit, const FitReport& reported,
               const FitOptions& options);
Json fit_json(const Session& session, const Fit& fit, const FitReport& reported, const FitOptions& options);

/// Of several sessions together what is each one's own, beside what belongs to all; nothing of a session by itself.
void print_parts(const Output& output, const Session& session, const Fit& fit, const FitReport& reported);
Json parts_json(const Session& session, const Fit& fit, const FitReport& reported);

}  // namespace handsight::cli
