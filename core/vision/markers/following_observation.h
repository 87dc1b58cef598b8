// SPDX-License-Identifier: Apache-2.0
// Finding the known markers again among all corners of a stereo pair (thesis 4.3.2).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/message.h"
#include "vision/markers/known_markers.h"

namespace handsight {

struct MatchedMarker {
  int marker = 0;
  int left = -1;  // indices into the corners; -1: not seen by that camera
  int right = -1;
};

struct Match {
  std::vector<MatchedMarker> markers;  // by marker; empty where the match is refused
  Rigid sensor_from_body;              // fitted to the triangulated markers
  double body_offset = 0;              // m, of the markers' centroid from its prediction
  Message reason;                      // why it is refused; empty: accepted
  bool accepted() const { return reason.empty(); }
};

/// Every epipolar pair is triangulated and may be any marker that it is near enough to (prediction and gates). Side
/// lengths decide: three pairs that agree with the known lengths within 3 sigma of the triangulated points (and of the
/// known markers) give a pose; every marker that a pair then meets within the marker gate joins. The pose with the
/// most markers wins, of equal ones that with the least misfit; two that are equally good and put the body in
/// different places are refused. No corner is used twice. A marker that only one camera shows joins where a single
/// corner lies within 3 sigma of its projection. With `prediction` absent nothing is known of where the body is.
/// Three markers are needed for a pose; of sessions that have only one or two, all of them.
Match match_markers(const StereoRig& rig, const std::vector<Corner>& left, const std::vector<Corner>& right,
                    const KnownMarkers& known, const std::optional<Rigid>& predicted_sensor_from_body,
                    const MatchOptions& options = {});

}  // namespace handsight
