// SPDX-License-Identifier: GPL-3.0-or-later
// The robot as effects bend it.
#pragma once

#include "estimation/problem/problem.h"

namespace handsight::app {

/// One motion per link of the robot (root frame) in an observation, an index into Session::observations, with these
/// effects; without any: as the robot's own description has it.
std::vector<Rigid> bent_links(const ProblemSource& source, int observation, const std::vector<EffectTerm>& terms);

/// The effects of a problem with other numbers in its columns.
std::vector<EffectTerm> terms_with(const Problem& problem, const Eigen::VectorXd& values);

}  // namespace handsight::app
