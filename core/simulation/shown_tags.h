// SPDX-License-Identifier: Apache-2.0
// Bodies of tags as a simulation shows them.
#pragma once

#include <vector>

#include "session/session.h"
#include "simulation/random.h"

namespace handsight {

/// The mean of the points.
Vector3 mean_point(const std::vector<Vector3>& points);

/// The outward normals of the tags' faces in the target's frame, one a marker; empty where all are the same.
std::vector<Vector3> face_normals(const Target& target);

/// Where the markers really are in the target's frame (m): as described, each tag moved anew within its sigmas.
std::vector<Vector3> really_placed(const KnownShape& shape, Random& random);

/// m: the white rim round one tag that neither covers another's nor stands out over an edge of the body.
double rim_of_tag(const Target& target, std::size_t tag);

}  // namespace handsight
