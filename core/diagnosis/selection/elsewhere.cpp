// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/selection/elsewhere.h"

#include <fmt/format.h>

#include "diagnosis/verdict/explanation.h"
#include "estimation/report/part_report.h"

namespace handsight {

void set_errors_elsewhere(Diagnosis& d) {
  d.report.held_out_region = region_error(d);
  if (!d.model.session.parts.empty() && d.report.held_out_sessions.empty())
    hold_out_sessions(d.model.session, d.model.fit, d.model_options, d.report);
}

/// The error of sessions that the robot was not learned from.
static ErrorSummary session_error(Diagnosis d) {
  set_errors_elsewhere(d);
  return d.report.held_out_session;
}

Message worse_elsewhere(const Diagnosis& before, Diagnosis& after, double most) {
  const auto size = [](const ErrorSummary& e) { return e.rms_pixel ? e.rms_pixel : e.rms_m; };
  after.report.held_out_region = region_error(after);
  const ErrorSummary was = region_error(before), &is = after.report.held_out_region;
  if (size(was) && size(is) && *size(is) > most * *size(was))
    return message("where a whole region of poses is held out, the error rises from {} to {}", error_text(was),
                   error_text(is));
  if (after.model.session.parts.empty()) return "";
  set_errors_elsewhere(after);
  const ErrorSummary before_it = session_error(before), &with_it = after.report.held_out_session;
  if (!size(before_it) || !size(with_it) || *size(with_it) <= most * *size(before_it)) return "";
  return after.model.session.is_touch() ? message("where a whole fixture is held out, the error rises from {} to {}",
                                                  error_text(before_it), error_text(with_it))
                                        : message("where a whole session is held out, the error rises from {} to {}",
                                                  error_text(before_it), error_text(with_it));
}

}  // namespace handsight
