// SPDX-License-Identifier: Apache-2.0
// Where nothing that is measured tells a length, the robot does: a ball put into a socket again and again stays in one
// place whatever the robot's size, and best of all where the robot has shrunk to nothing.
#pragma once

#include "estimation/problem/problem.h"

namespace handsight {

/// How well the size of a robot is known where nothing else tells a length, as a share (one standard deviation).
inline constexpr double robot_scale_sigma = 1e-3;

/// Do the measurements tell no length: was every marker measured at one place only?
bool measures_no_length(const Session& session, const Chain& chain);

/// The robot's size is how far, in postures all over its joints' range, that point of the TCP's link moves against the
/// mount's link that moves least. `problem`: with its source.
RobotScale described_scale(const Problem& problem);

/// Problem::robot_scale where the effects stand now; nothing where the problem has none.
void follow_robot_scale(Problem& problem);

/// Is the robot's size a prior of the problem's effects?
inline bool holds_robot_scale(const Problem& p) {
  return p.robot_scale && p.effect_count() > 0 && p.robot_scale->by_effect.size() == p.effect_count();
}

}  // namespace handsight
