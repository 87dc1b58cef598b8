// SPDX-License-Identifier: Apache-2.0
// Observations of which each alone is wrong: a reading that slipped, an image of another pose.
#pragma once

#include "base/message.h"
#include "estimation/fit/fit.h"

namespace handsight {

/// An observation that none of the others agrees with, while these agree with each other.
struct LoneObservation {
  std::int64_t id = 0;
  int index = 0;      // into Session::observations
  double error = 0;   // px or m, rms of a coordinate, where the others have it
  double others = 0;  // the largest of theirs
};

/// Those without which the fit leaves every other observation at least six times better than it predicts these: no
/// effect bends one pose alone. At most one in twenty, and none where they are several at the beginning or the end of
/// the session: that is what a slip looks like. Nothing where it leaves less than ten times the noise, or with fewer
/// than eight others. `fit`: of this session with these options, by images and free markers.
std::vector<LoneObservation> lone_observations(const Session& session, const Fit& fit, const FitOptions& options);

/// The session with these excluded, and why.
Session without(const Session& session, const std::vector<LoneObservation>& lone);

/// "Observation 8 is left out: ...", or "stands alone: ..." where it still counts; empty where there is none.
Message lone_text(const std::vector<LoneObservation>& lone, bool is_tracker, bool is_left_out = true);

}  // namespace handsight
