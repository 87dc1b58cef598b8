// SPDX-License-Identifier: Apache-2.0
#include "blunders/reported_error.h"

#include "estimation/report/fit_report.h"

namespace handsight {

double reported_error(const Session& session, const Fit& fit) {
  const ErrorSummary error = error_on(session, fit);
  return (session.is_tracker() ? error.mean_m : error.rms_pixel).value_or(fit.residual_rms);
}

}  // namespace handsight
