// SPDX-License-Identifier: Apache-2.0
// What two fits of touches differ by, number by number. Internal to comparison.cpp.
#pragma once

#include "compare/comparison_result.h"
#include "estimation/fit/fit_result.h"
#include "session/session.h"

namespace handsight {

/// The tip's place on the hand (its TCP's frame) and, of each fixture that is estimated in both fits, what touches tell
/// of its place: three numbers of a point and a length's end (its link's frame); of a plane and a gauge how far
/// it moved along its normal or axis, and by how much it tilted about its own x and y. Left out is
/// what one of them does not determine. `first` is the session of `a`, whose fixtures the other one has too.
std::vector<NumberChange> list_touch_numbers(const Session& first, const Session& second, const Fit& a, const Fit& b);

}  // namespace handsight
