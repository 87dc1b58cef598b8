// SPDX-License-Identifier: Apache-2.0
// Start values in closed form, for markers seen by two cameras, by one, or as points, and for any unknown mount.
#pragma once

#include "estimation/problem/problem.h"
#include "session/session.h"

namespace handsight {

/// Start for a fit. With a known mount, or a guessed one, the markers follow from it. An estimated mount is also
/// found without any guess: root_from_tcp x = root_from_mount (R p + t) is linear in marker, R and t; R is brought to
/// the nearest rotation, and 24 rotations all round compete with it; the best by 3D residuals is taken, the guess too
/// where there is one. Nothing where an unknown mount cannot be found: no marker seen as a point.
std::optional<Unknowns> start_values(const Problem& problem, const Mount& mount);

}  // namespace handsight
