// SPDX-License-Identifier: Apache-2.0
// A start in closed form from points, for any unknown mount.
#pragma once

#include <optional>

#include "estimation/problem/problem.h"

namespace handsight {

/// As start_values (start.h), without what is known of the markers' shape and without the effects' numbers.
std::optional<Unknowns> start_by_points(const Problem& problem, const Mount& mount);

}  // namespace handsight
