// SPDX-License-Identifier: Apache-2.0
#include "robot/posture.h"

namespace handsight {

Posture solve_posture(const Robot& robot, const Eigen::VectorXd& sensor, const Vector3& gravity) {
  return solve_posture<double>(robot, sensor, RobotChange{}, gravity);
}

Eigen::VectorXd joint_values(const Robot& robot, const std::vector<int>& joints, const Eigen::VectorXd& position) {
  check(static_cast<std::size_t>(position.size()) == joints.size(), "{} positions for {} joints", position.size(),
        joints.size());
  Eigen::VectorXd values = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(robot.joints.size()));
  for (std::size_t i = 0; i < joints.size(); ++i) values[joints[i]] = position[static_cast<Eigen::Index>(i)];
  auto value = [&](auto&& self, int j) -> double {
    if (!robot.joints[j].is_mimic()) return values[j];
    double sum = 0;
    for (const Mimic& m : robot.joints[j].mimics) sum += m.multiplier * self(self, m.joint) + m.offset;
    return sum;
  };
  for (std::size_t j = 0; j < robot.joints.size(); ++j)
    if (robot.joints[j].is_mimic()) values[static_cast<Eigen::Index>(j)] = value(value, static_cast<int>(j));
  return values;
}

}  // namespace handsight
