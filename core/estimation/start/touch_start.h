// SPDX-License-Identifier: Apache-2.0
// Where a fit of touches starts: the probe's tip and the fixtures, by the robot as it is described.
#pragma once

#include "estimation/problem/problem.h"

namespace handsight {

/// The tips by the points that they were put into (linear in tip and socket), else at the TCP; fixtures that the
/// session does not place by what the tips then show: a point in their middle, a plane through them. InputError names a
/// plane that fewer than three touches show.
Unknowns touch_start(const Session& session, const Problem& problem);

}  // namespace handsight
