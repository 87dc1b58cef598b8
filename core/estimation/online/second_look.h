// SPDX-License-Identifier: Apache-2.0
// A rejected observation is looked at again with wider gates, so that it can be said whose fault it was.
#pragma once

#include <optional>
#include <unordered_map>

#include "estimation/fit/fit.h"
#include "estimation/online/online.h"

namespace handsight {

/// Markers that a second look found, by observation; none where it found nothing.
using SecondLooks = std::unordered_map<std::int64_t, std::vector<Sighting>>;

/// Was it rejected, without any marker, and are there two images to look at again?
bool wants_second_look(const Session& session, const Observation& observation);

/// The markers of an observation whose body is far from its prediction (the robot is to blame), whose sides do not have
/// their lengths (the body), or whose images do not fit together (the cameras); tried in this order, each only where
/// the one before finds nothing. For looking only: such markers never become part of a fit. Nothing where no three
/// corners come near.
std::optional<std::vector<Sighting>> second_look(const Session& session, const Fit& fit, const Observation& observation,
                                                 const ImagePair& images);

}  // namespace handsight
