// SPDX-License-Identifier: Apache-2.0
// One guess which corner pair is which marker, and the body pose that follows.
#pragma once

#include <optional>
#include <vector>

#include "vision/markers/corner_pairs.h"
#include "vision/markers/known_markers.h"

namespace handsight {

/// A corner pair that may be a marker.
struct MarkerNode {
  int marker = 0;
  int pair = 0;  // index into the pairs
};

struct BodyHypothesis {
  std::vector<MarkerNode> nodes;
  Rigid sensor_from_body;
  double misfit = 0;       // chi-squared of the markers on the fitted body, plus the offset from the prediction
  double body_offset = 0;  // m
  double body_turn = 0;    // rad
};

/// Does the distance of two pairs agree with that of their markers, within 3 sigma of both?
bool lengths_agree(const std::vector<CornerPair>& pairs, const KnownMarkers& known, const MarkerNode& a,
                   const MarkerNode& b);

/// The body pose from these nodes (three or more, or all markers of a smaller body), with every further node that it
/// meets within the gate, each marker and each corner once. Nothing where a node misses its place by more than the
/// gate.
std::optional<BodyHypothesis> body_hypothesis(const std::vector<CornerPair>& pairs, const KnownMarkers& known,
                                              const std::vector<MarkerNode>& seed,
                                              const std::vector<MarkerNode>& all_nodes,
                                              const std::optional<Rigid>& prediction, const MatchOptions& options);

}  // namespace handsight
