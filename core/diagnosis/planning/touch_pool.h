// SPDX-License-Identifier: Apache-2.0
// Postures in which a robot could touch the fixtures of its session next.
#pragma once

#include "diagnosis/planning/pose_pool.h"

namespace handsight {

struct TouchPool {
  std::vector<Eigen::VectorXd> poses;  // rad or m, in the order of the session's joints
  std::vector<int> fixtures;           // that each touches, into Session::fixtures
};

/// Up to `count` postures, as many for each fixture as for any other, by the fitted robot: within all joint limits, the
/// tip no farther from where the fixture was touched than touches were, from the side that it was touched from, at
/// readings that it has shown. The same for the same seed. InputError where none is found.
TouchPool touch_pool(const Session& session, const Fit& fit, const PoseJudge& judge, int count, std::uint64_t seed);

/// Where a marker is by the fit, or for -1 the TCP, in the fixture's frame (m) in a posture (rad or m).
Vector3 place_in_fixture(const Fit& fit, int fixture, const Eigen::VectorXd& position, int marker);

}  // namespace handsight
