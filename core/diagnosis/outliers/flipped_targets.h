// SPDX-License-Identifier: Apache-2.0
// Flat targets whose pose flipped: from nearly in front two tilts look alike, and a detector may tell the wrong one.
#pragma once

#include <string>
#include <vector>

#include "base/message.h"
#include "estimation/fit/fit.h"

namespace handsight {

struct FlippedTarget {
  int index = 0;  // into Session::observations
  std::int64_t id = 0;
  double turned = 0;        // rad: how far the told pose is turned from where it should be
  double when_flipped = 0;  // rad: the same of its mirror tilt
};

/// The pose with the tilt mirrored about the line of sight to the target's origin; the target is flat, its normal z.
Rigid mirrored_tilt(const Rigid& sensor_from_target);

/// The observations of a pose sensor that are far off as they are reported and right once their tilt is mirrored, in
/// order; empty for other sensors. They may be in the fit or not: the target's place on the TCP is judged by the
/// majority.
std::vector<FlippedTarget> flipped_targets(const Session& session, const Fit& fit);

/// The session with these excluded.
Session without_flipped(Session session, const std::vector<FlippedTarget>& flipped);

/// A sentence that names them; empty where there are none.
Message flipped_text(const std::vector<FlippedTarget>& flipped);

}  // namespace handsight
