// SPDX-License-Identifier: Apache-2.0
// Which single change of the second side explains what the two sides of a comparison do not share. Internal to
// comparison.cpp.
#pragma once

#include "compare/comparison_result.h"
#include "compare/shared_model.h"

namespace handsight {

struct RankedChanges {
  std::vector<Change> changes;  // best first
  double threshold = 0;
  LeftOver left;        // what even all changes together leave; p is 1 where it was not asked
  ComparedSides sides;  // as they were, with the scatter and the sizes that were found
};

/// `held`: changes of the second side that are there already, with values; scatter and sizes then stay as given.
RankedChanges ranked_changes(const ComparedSides& sides, const std::vector<EffectTerm>& held);

}  // namespace handsight
