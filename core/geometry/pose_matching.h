// SPDX-License-Identifier: Apache-2.0
// Which rows of two tables of poses belong together where their order is unknown.
#pragma once

#include <optional>
#include <vector>

#include "geometry/rigid.h"

namespace handsight {

struct PoseMatching {
  Rigid x;                                       // of A_i X B_k, which is the same for all pairs
  std::vector<std::optional<std::size_t>> of_b;  // for each row of B the row of A; no row of A twice

  std::size_t count() const;
};

/// The pairs (i, k) for which A_i X B_k is the same, of as many rows as can be. Between two rows the motion of A and
/// that of B turn by the same angle and move as far along their axes, whatever X is (Chen 1991, "A screw motion
/// approach to uniqueness analysis of head-eye geometry"); three rows by which angles and ways agree give an X, and the
/// one that pairs most is kept. A and B as in hand_eye_consensus. Nothing with fewer than 8 rows, or where no two axes
/// of motions differ. Robots and sensors may err by some milliradians and millimetres.
std::optional<PoseMatching> match_poses(const std::vector<Rigid>& a, const std::vector<Rigid>& b);

}  // namespace handsight
