// SPDX-License-Identifier: Apache-2.0
// What a fit of several sessions together says of each of them.
#pragma once

#include <functional>
#include <string>

#include "estimation/fit/fit_parts.h"
#include "estimation/report/fit_report.h"

namespace handsight {

/// Of one part of a joined session; pixels and metres are its own sensor's.
struct PartReport {
  std::string title;
  bool has_cameras = false;
  FitPart found;
  int observations = 0, used = 0;
  ErrorSummary fitted, held_out;                   // held out as FitReport::held_out
  ErrorSummary held_out_session;                   // the robot from the other parts alone; where asked for
  std::vector<ObservationReport> per_observation;  // ids as the session itself has them
};

/// Part by part; `told` must be the fit's own report. Empty where the session is none of several.
std::vector<PartReport> part_reports(const Session& joined, const Fit& fit, const FitReport& reported);

/// A part's report as that of a session by itself.
FitReport make_report(const PartReport& part);

/// Sets FitReport::held_out_session: the robot's effects from all other parts; in the part that is held out only what
/// is its own (mount, body, its own effects, joints that no other part moves), fitted on four fifths of it, the error
/// on the fifth, five times. Absent of a part whose own numbers cannot be fitted without the others. `go_on` is asked
/// after each part. Nothing where the session is none of several.
void hold_out_sessions(const Session& joined, const Fit& fit, const FitOptions& options, FitReport& reported,
                       const std::function<bool()>& go_on = {});

}  // namespace handsight
