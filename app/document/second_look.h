// SPDX-License-Identifier: GPL-3.0-or-later
// A rejected observation is looked at again with wider gates, so that Inspect can say whose fault it was.
#pragma once

#include <optional>

#include "estimation/fit.h"
#include "estimation/online.h"

namespace handsight::app {

/// The markers of an observation whose body is far from its prediction (the robot is to blame), whose sides do not have
/// their lengths (the body), or whose images do not fit together (the cameras); tried in this order, each only where
/// the one before finds nothing. For looking only: such markers never become part of a fit. Nothing where no three
/// corners come near.
std::optional<std::vector<Sighting>> second_look(const Session& session, const Fit& fit, const Observation& observation,
                                                 const ImagePair& images);

}  // namespace handsight::app
