// SPDX-License-Identifier: Apache-2.0
// Chessboards that look the same after half a turn: which way round each image has numbered them, by the robot's
// motion.
#pragma once

#include "estimation/problem/problem.h"

namespace handsight {

/// Per observation of the problem: is its board numbered the other way round than most? The middle of the board and its
/// normal do not depend on it; with them and the mount the turn about the normal follows to half a turn. Which of the
/// two is the board's own nothing tells: the more frequent one stands. Nothing (all 0) where no pose is seen.
std::vector<char> half_turned(const Problem& problem, const Mount& mount);

/// Point m becomes point count - 1 - m.
void turn_by_half(std::vector<Sighting>& sightings, int count);

/// Turns the boards of a session that has such a target; returns how many.
int undo_target_symmetry(Session& session);

}  // namespace handsight
