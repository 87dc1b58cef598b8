// SPDX-License-Identifier: Apache-2.0
#include "experiment/recheck/recheck_poses.h"

#include "compare/change_watch.h"
#include "experiment/paths/collision_world.h"

namespace handsight {

std::vector<Eigen::VectorXd> recheck_poses(const CalibratedRobot& before, const Session& session, const Cell& cell,
                                           int count) {
  std::vector<Eigen::VectorXd> positions = before.positions;
  if (positions.empty())
    for (const Observation& one : session.observations)
      if (is_used(one)) positions.push_back(one.position);
  if (positions.empty())
    throw InputError(
        "Neither the calibration nor the session says where the robot was measured: no pose to recheck in.");
  std::vector<Eigen::VectorXd> taken, free;
  for (const Observation& one : session.observations) taken.push_back(one.position);
  const CollisionWorld world(make_chain(session), robot_solids(session), cell, taken);
  for (const Eigen::VectorXd& q : positions)
    if (!world.touching(q)) free.push_back(q);
  if (static_cast<int>(free.size()) >= count) positions = free;
  std::vector<Eigen::VectorXd> poses;
  for (const std::size_t place : telling_poses(before, session, positions, count)) poses.push_back(positions[place]);
  return poses;
}

}  // namespace handsight
