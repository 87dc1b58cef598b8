// SPDX-License-Identifier: Apache-2.0
// How well the motions of a flange and what a sensor saw go together: the test of how poses are to be read.
#pragma once

#include <optional>
#include <vector>

#include "base/message.h"
#include "geometry/rigid.h"

namespace handsight {

/// What is left of the motions between pairs of poses, in the median: of the turn and of the shift.
struct Misfit {
  double turn = 0;   // rad
  double shift = 0;  // m

  /// Both in one number, rad: a shift as if it were 0.3 m away.
  double size() const;
};

/// rad: what is left (Misfit::size) of motions that go together, however noisy.
constexpr double most_misfit = 0.15;

/// "0.17 degrees and 1.3 mm".
Message misfit_text(const Misfit& misfit);

/// The flange's motions carried over to the target's by the one fixed transform that suits them best, found in closed
/// form and against outliers. `base_from_flange` and `sensor_from_target` are paired; `eye_in_hand`: the flange carries
/// the sensor, else the target. Nothing with fewer than four poses, or where nothing turns.
std::optional<Misfit> hand_eye_misfit(const std::vector<Rigid>& base_from_flange,
                                      const std::vector<Rigid>& sensor_from_target, bool eye_in_hand);

}  // namespace handsight
