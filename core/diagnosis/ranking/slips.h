// SPDX-License-Identifier: Apache-2.0
// Is a slip at one moment believable? It is cheap to add and costly when wrong.
#pragma once

#include "estimation/fit/fit_options.h"
#include "estimation/fit/fit_result.h"
#include "session/session.h"

namespace handsight {

/// A slip that is real lowers what is left of the observations on both sides of it when blocks of neighbours in time
/// are held out, not only folds that lie between each other, and by more than chance: the sum of what the observations
/// gain is beyond 2.3 of its own standard deviations (self-normalised, so that heavy tails do not matter). `without`
/// and `with` are fits of the same session, with their options.
bool slip_is_confirmed(const Session& session, const Fit& without, const FitOptions& without_options, const Fit& with,
                       const FitOptions& with_options, double order);

}  // namespace handsight
