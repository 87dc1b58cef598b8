// SPDX-License-Identifier: Apache-2.0
// Starts in competition, for a fit that a plain start has led nowhere.
#pragma once

#include "estimation/solvers/least_squares.h"

namespace handsight {

/// Does a fit of the images look lost: not converged, a marker behind a camera that saw it, or left with residuals that
/// few robots explain (more than 0.3 % of the focal length, 3 mm at a metre; with a tracker 30 mm)?
bool looks_lost(const Problem& images, const Solution& solution);

/// Is a solution none that anybody should use: a marker behind a camera that saw it, or residuals that no robot
/// explains (more than 3 % of the focal length; with a tracker 0.3 m)?
bool is_no_answer(const Problem& images, const Solution& solution);

/// The best few starts for these images, best first; none where nothing but `given` can be tried (a known mount and
/// cameras that no effect moves). In stages, each on a spread of the observations:
/// - where cameras are free the first one alone, which the rig cannot mislead; effects stay as they are;
/// - the mount: the given rotation, those 25 degrees beside it and rotations all round, translation and markers by the
///   linear system of the viewing rays; a few steps from each, the best are followed;
/// - then the numbers of the first camera, then all of the cameras and the rig.
std::vector<Unknowns> competing_starts(const Problem& images, const Unknowns& given);

}  // namespace handsight
