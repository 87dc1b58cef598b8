// SPDX-License-Identifier: Apache-2.0
// Which mistake of a whole kind makes a session right that leaves more than noise and geometry can explain.
#pragma once

#include <functional>
#include <vector>

#include "blunders/blunder.h"
#include "estimation/fit/fit.h"

namespace handsight {

/// Is so much left that a search for blunders is worth its seconds: the fit is lost, or leaves many times the noise
/// (where that is not known several px or mm)?
bool may_be_a_blunder(const Session& session, const Fit& fit);

/// The blunder that makes the session right, or the two that do together; empty where none does so clearly. Each single
/// one is tried, then pairs. Named is only what leaves less than half, a sensible answer, and what neither the offsets
/// of all joints nor the numbers of the whole geometry explain as well. `fit` is of the session. `on_progress` is
/// called with the share that is done (0 to 1); where it returns false the search ends with nothing.
std::vector<Blunder> find_blunders(const Session& session, const Fit& fit,
                                   const std::function<bool(double)>& on_progress = {});

/// Of these only what was seen in another order than the robot's (pairing_order.h), which a part of a session does not
/// show.
std::vector<Blunder> find_wrong_order(const Session& session, const Fit& fit);

}  // namespace handsight
