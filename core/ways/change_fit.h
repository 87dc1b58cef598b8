// SPDX-License-Identifier: Apache-2.0
// Which single change of the second side explains what the two sides of a comparison do not share. Internal to
// comparison.cpp.
#pragma once

#include <optional>

#include "ways/change_candidates.h"
#include "ways/comparison.h"

namespace handsight {

struct ComparedSide {
  Problem problem;
  double weight = 1;  // of its rows: the noise's inverse
};

struct ComparedSides {
  std::optional<ComparedSide> before;  // absent: what is known of it is `known`
  ComparedSide after;
  Unknowns start;
  /// Without a first side: the precision of the shared unknowns about `start`, by the columns xi of the markers
  /// together (m, rad, TCP frame), mount where it is estimated, effects in units of their plausible size.
  std::optional<Eigen::MatrixXd> known;
  Matrix6 scatter = Matrix6::Zero();  // of the body in the sensor's frame; with a first side it is found
};

struct RankedChanges {
  std::vector<Change> changes;  // best first
  double threshold = 0;
  Matrix6 scatter = Matrix6::Zero();
};

/// `held`: changes of the second side that are there already, with values.
RankedChanges ranked_changes(const ComparedSides& sides, const std::vector<EffectTerm>& held);

}  // namespace handsight
