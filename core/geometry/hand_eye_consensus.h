// SPDX-License-Identifier: Apache-2.0
// Hand and eye by consensus: which rows of two tables of poses belong together though up to half of them do not.
#pragma once

#include <optional>
#include <vector>

#include "geometry/rigid.h"

namespace handsight {

struct HandEyeConsensus {
  Rigid x;                   // of A_i X B_i, which is the same for all rows that agree
  std::vector<bool> agrees;  // one a row
  double left = 0;           // rad: what the rows that agree leave, r.m.s.; a shift as a turn 0.3 m away

  std::size_t count() const;
};

/// The X for which A_i X B_i is the same in the most rows: of many drawn triples of rows (seed fixed) the one by which
/// the better half of all rows leaves least, then by all rows that agree with it. Rousseeuw and Leroy 1987, Robust
/// Regression and Outlier Detection. With an eye in hand A is base_from_flange, else flange_from_base; B is
/// sensor_from_target. Where all motions turn about one axis, X's place along it is 0, as nothing tells it. Nothing
/// with fewer than 8 rows, or where nothing turns.
std::optional<HandEyeConsensus> hand_eye_consensus(const std::vector<Rigid>& a, const std::vector<Rigid>& b);

}  // namespace handsight
