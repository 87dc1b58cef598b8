// SPDX-License-Identifier: Apache-2.0
// A distance between fixtures that was typed wrongly: the touches themselves contradict it.
#pragma once

#include <optional>

#include "base/message.h"
#include "estimation/fit/fit.h"

namespace handsight {

struct DistanceDoubt {
  int distance = 0;                      // into Session::distances
  double measured = 0;                   // m: what the touches say of it
  double rms_before = 0, rms_after = 0;  // m, of one reading: with the distances as they are given, and without
  Message text;                          // one sentence: what contradicts, and what to do
};

/// The distance that the touches contradict most, where without any they agree ten times better. `options` are those of
/// the fit. Nothing where a session has no known distances between fixtures on one link.
std::optional<DistanceDoubt> doubtful_distance(const Session& session, const Fit& fit, const FitOptions& options);

}  // namespace handsight
