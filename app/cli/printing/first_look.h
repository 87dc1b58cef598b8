// SPDX-License-Identifier: Apache-2.0
// What `check` finds by a fit that nobody has asked for yet.
#pragma once

#include "estimation/report/session_check.h"
#include "printing/blunder_output.h"

namespace handsight::cli {

struct FirstLook {
  std::optional<TargetSize> size;
  std::optional<DistanceDoubt> distance;
  std::vector<Blunder> blunders;
};

/// By plain fits of at most 100 observations; nothing where the check has found problems. What is found of the target's
/// size and of distances, and an error that nothing explains, is added to the warnings.
FirstLook first_look(const Session& session, SessionCheck& check);

/// check_json with target_size, doubtful_distance and blunders.
Json first_look_json(const Session& session, const SessionCheck& check, const FirstLook& look);

}  // namespace handsight::cli
