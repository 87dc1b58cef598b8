// SPDX-License-Identifier: Apache-2.0
// A flat board that is bent a little, as a sheet bends: lengths along it stay as they are.
#pragma once

#include <vector>

#include "geometry/rigid.h"

namespace handsight {

/// The middle of a board's points, m.
Vector3 find_middle(const std::vector<Vector3>& points);

/// Where a bend carries a point of the board, m: z moves by half of (u, v) K (u, v), and the place along the board
/// draws in by what the bow takes; u, v from the middle, K the curvatures (bend 0 along x, 1 along y, 2 askew; 1/m).
Vector3 bent_point(const Vector3& described, const Vector3& middle, const Vector3& bend, Matrix3* by_bend = nullptr);

}  // namespace handsight
