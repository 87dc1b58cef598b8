// SPDX-License-Identifier: Apache-2.0
// The error where the robot has not been measured decides what a change of a model is worth.
#pragma once

#include "base/message.h"
#include "diagnosis/verdict/diagnosis_result.h"

namespace handsight {

/// Times the error before: chance of where regions end.
inline constexpr double most_elsewhere = 1.02;

/// Is the error larger where the robot has not been measured: in a region of its poses, or of several sessions together
/// in one that is held out? What time seems to explain where poses come region by
/// region, and what only bends to the poses at hand, shows there. Why a change is refused then; empty where it is not.
/// Works the regions' errors of `after` out.
/// `most`: times the error before that is no rise.
Message worse_elsewhere(const Diagnosis& before, Diagnosis& after, double most = most_elsewhere);

/// Works FitReport::held_out_region of a model out, and of several sessions together held_out_session, where that is
/// not done yet.
void set_errors_elsewhere(Diagnosis& model);

}  // namespace handsight
