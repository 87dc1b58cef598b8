// SPDX-License-Identifier: Apache-2.0
// Ways from one posture to another: straight in the joints, else round what is in the way by RRT-Connect (Kuffner and
// LaValle 2000, as OMPL has it; Debian: libompl-dev).
#pragma once

#include "experiment/paths/collision_world.h"

namespace handsight {

/// What every joint may take, in the order of Chain::joints, rad (m).
struct JointRanges {
  Eigen::VectorXd lower, upper;

  bool hold(const Eigen::VectorXd& position) const;
};

/// The limits of the robot less a margin of a hundredth of the range, 1 degree (5 mm) at least; a joint without limits
/// may go half a turn (0.3 m) beyond what was taken.
JointRanges joint_ranges(const Chain& chain, const std::vector<Eigen::VectorXd>& taken);

/// Points from the step after `from` up to `to`, of steps of 2 degrees (10 mm) at most in each joint in which no point
/// of the robot moves by more than the clearance. `finer`: so many times more of them.
std::vector<Eigen::VectorXd> steps_between(const CollisionWorld& world, const Chain& chain, const Eigen::VectorXd& from,
                                           const Eigen::VectorXd& to, int finer = 1);

/// Free of collisions at all its steps, with clearance. No solid then touches another in between: each is within half
/// the clearance of where it was checked.
bool is_free(const CollisionWorld& world, const Chain& chain, const Eigen::VectorXd& from, const Eigen::VectorXd& to);

/// The points of a free way after `from`, `to` the last; nothing where none is found within `seconds`.
std::optional<std::vector<Eigen::VectorXd>> way_between(const CollisionWorld& world, const Chain& chain,
                                                        const JointRanges& ranges, const Eigen::VectorXd& from,
                                                        const Eigen::VectorXd& to, double seconds = 0.5);

/// Out of a corner: a free way that goes back along `back` first, the points after `from` to where the robot stood
/// before. Nothing where `back` has none, is not free any more, or leads nowhere from which `to` is found.
std::optional<std::vector<Eigen::VectorXd>> way_by_going_back(const CollisionWorld& world, const Chain& chain,
                                                              const JointRanges& ranges, const Eigen::VectorXd& from,
                                                              const std::vector<Eigen::VectorXd>& back,
                                                              const Eigen::VectorXd& to, double seconds = 0.5);

/// The way of the fastest joint, rad (m), along these points.
double measure_length(const Eigen::VectorXd& from, const std::vector<Eigen::VectorXd>& way);

}  // namespace handsight
