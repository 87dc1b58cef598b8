// SPDX-License-Identifier: Apache-2.0
// What it costs that the causes were chosen by the very observations that then tell how good the choice is.
#pragma once

#include <functional>
#include <optional>

#include "estimation/fit/fit_result.h"
#include "estimation/report/error_summary.h"
#include "session/session.h"

namespace handsight {

/// Are the poses of a fit few to choose causes by? With more, choosing costs little beside what it gains.
bool are_few_to_choose_by(const Fit& fit);

/// May the choice be made five times more, after so many models of the fit's size were tried? A board's hundreds of
/// corners would take minutes, and bend to chance less.
bool is_cheap_to_choose(const Fit& fit, int models);

/// The error of observations that took no part in choosing: the causes are chosen anew, by `choose`, without each of
/// the folds that the held-out error has (FitReport::held_out), of the observations that `chosen` uses, and the fold's
/// error is told. Where a model chosen so has no answer, or `choose` gives nothing (it was stopped), there is no error.
std::optional<ErrorSummary> error_with_choosing(const Session& session, const Fit& chosen,
                                                const std::function<std::optional<Fit>(const Session& part)>& choose);

}  // namespace handsight
