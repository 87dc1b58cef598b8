// SPDX-License-Identifier: Apache-2.0
// How large a robot's own error is, from what a fit leaves.
#pragma once

#include <string>

#include "base/message.h"
#include "estimation/solvers/least_squares.h"

namespace handsight {

/// The sizes of the flange's error under which what the solution leaves is likeliest (restricted likelihood, so that
/// the unknowns that followed the errors are allowed for; Searle, Casella and McCulloch, Variance Components, 1992, ch.
/// 6). Problem::noise must be the noise of one coordinate, and the motions of a robot with joints filled
/// (with_motions). None where the noise alone does as well (less than 3 in ln), where it would be more than 6 mm or 18
/// mrad, or with fewer than four observations.
FlangeError likely_flange_error(const Problem& problem, const Solution& solution);

/// A sentence of what was found, for people.
Message flange_error_text(const FlangeError& error, bool has_joints);

}  // namespace handsight
