// SPDX-License-Identifier: Apache-2.0
// A fit of several sessions together as a fit of one of them.
#pragma once

#include "estimation/fit/fit_result.h"
#include "session/session.h"

namespace handsight {

/// One part of a joined session as if it had been fitted by itself, with what the others say of the robot in its
/// numbers and covariances: what is exported of it, and predicted.
struct PartFit {
  Session session;  // part_session
  Fit fit;
};

/// The robot's effects as they are in all, those of this part as the effects of the whole session that they are when it
/// stands alone, its own body, markers and mount. Slips count its own observations.
PartFit fit_of_part(const Session& joined, const Fit& fit, int part);

/// The part of that title. InputError lists the titles where there is none; of a session by itself, where one is asked
/// for, that it is none of several.
int part_named(const Session& joined, const std::string& title);

}  // namespace handsight
