// SPDX-License-Identifier: Apache-2.0
// What is known of the markers before they are looked for again, and how far off they may be.
#pragma once

#include <optional>
#include <vector>

#include "vision/markers/corner_pairs.h"

namespace handsight {

/// What is known of the markers: positions in any frame fixed to them ("body"), and how well.
struct KnownMarkers {
  std::vector<std::optional<Vector3>> in_body;  // m, per marker; empty where it was never seen
  std::vector<double> sigma;                    // m, per marker: of one coordinate
};

struct MatchOptions {
  PairOptions pairs;
  double marker_gate = 0.005;  // m, thesis (4.53): how far a marker may be from the fitted body, plus 3 sigma
  double body_gate = 0.030;    // m: how far the body as a whole may be from its prediction (arms sag)
  double turn_gate = 0.20;     // rad: how far it may be turned from its prediction
};

}  // namespace handsight
