// SPDX-License-Identifier: Apache-2.0
// Observations that stand near each other: in one posture, or in one region of what was measured.
#pragma once

#include <vector>

#include "estimation/problem/problem.h"

namespace handsight {

/// Of each observation of the problem the rank of the first one whose joints all stand where its own do, within
/// 5e-3 rad (m); its own rank where there is none before it, and for robots of poses. What was measured again is no
/// second pose.
std::vector<int> first_of_same_pose(const Problem& problem);

/// What postures are described by, a row an observation: the measured joints' values and the hand's place (of the
/// nominal robot), each from 0 to 1 over these observations; 0 where it does not vary.
Eigen::MatrixXd posture_features(const Problem& problem);

/// Parts the observations into at most five regions by k-means of the joints' values, each over its range in these
/// observations, and of the hand's place over its spread. The start is fixed: from the mean outwards, each time what is
/// farthest from all before. Equal poses lie in one region.
std::vector<int> list_regions(const Problem& problem);

}  // namespace handsight
