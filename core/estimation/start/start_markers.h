// SPDX-License-Identifier: Apache-2.0
// What every start is made of: markers for a known mount, a spread of the observations, rotations all round.
#pragma once

#include "estimation/problem/problem.h"

namespace handsight {

/// Markers in the TCP frame for a known mount: the point nearest to all viewing rays (or the mean of all points).
/// Markers that nothing determines stay at the TCP's origin.
std::vector<Vector3> start_markers(const Problem& problem, const Rigid& mount_from_sensor);

/// A spread of at most `most` observations over the session.
Problem thinned(const Problem& problem, std::size_t most);

/// The 24 rotations that carry the axes onto the axes: no rotation is farther than 63 degrees from one of them.
std::vector<Matrix3> axis_rotations();

}  // namespace handsight
