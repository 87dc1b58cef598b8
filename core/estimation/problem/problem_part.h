// SPDX-License-Identifier: Apache-2.0
// Parts of a problem: those of a long one are made without a copy of the whole.
#pragma once

#include <functional>

#include "estimation/problem/problem.h"

namespace handsight {

/// All that the observations of a problem share, and none of them.
Problem without_observations(const Problem& problem);

/// The problem with the observations alone of which `is_taken` says so.
Problem take_part(const Problem& problem, const std::function<bool(const ProblemObservation&)>& is_taken);

/// The problem with the observations from `first` to before `last` (or the end of all) alone.
Problem take_stretch(const Problem& problem, std::size_t first, std::size_t last);

}  // namespace handsight
