// SPDX-License-Identifier: Apache-2.0
// A start for a fit from the known shape of what is seen: the pose of every observation, then a few points of each
// piece in place of all.
#pragma once

#include "estimation/problem/problem.h"

namespace handsight {

/// Start values where the shape of the markers is known and cameras see them, from the poses of the pieces in the
/// single observations (target_pose.h); those that may as well be tilted the other way are left out where there are
/// others. Nothing without a known shape, without cameras, or where no observation shows a pose.
std::optional<Unknowns> start_by_shape(const Problem& problem, const Mount& mount);

/// The unknowns with the markers as the shape has them, laid onto where they are; one piece.
Unknowns laid_onto(const KnownShape& shape, const Unknowns& unknowns);

/// Of the points that stand for a piece.
inline constexpr int few_of_a_piece = 4;

/// The points that stand for a piece, in its frame: its middle and three places 0.1 m along the axes.
std::vector<Vector3> few_points(const KnownShape& shape, int piece);

/// Sightings by their piece.
std::vector<std::vector<Sighting>> by_piece(const KnownShape& shape, const std::vector<Sighting>& sightings);

}  // namespace handsight
