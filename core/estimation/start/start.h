// SPDX-License-Identifier: Apache-2.0
// Start values in closed form, for markers seen by two cameras, by one, or as points, and for any unknown mount.
#pragma once

#include "estimation/solvers/least_squares.h"

namespace handsight {

/// Markers in the TCP frame for a known mount: the point nearest to all viewing rays (or the mean of all points).
/// Markers that nothing determines stay at the TCP's origin.
std::vector<Vector3> start_markers(const Problem& problem, const Rigid& mount_from_sensor);

/// Start for a fit. With a known mount, or a guessed one, the markers follow from it. An estimated mount is also
/// found without any guess: root_from_tcp x = root_from_mount (R p + t) is linear in marker, R and t; R is brought to
/// the nearest rotation, and 24 rotations all round compete with it; the best by 3D residuals is taken, the guess too
/// where there is one. Nothing where an unknown mount cannot be found: no marker seen as a point.
std::optional<Unknowns> start_values(const Problem& problem, const Mount& mount);

/// A spread of at most `most` observations over the session.
Problem thinned(const Problem& problem, std::size_t most);

/// The 24 rotations that carry the axes onto the axes: no rotation is farther than 63 degrees from one of them.
std::vector<Matrix3> axis_rotations();

}  // namespace handsight
