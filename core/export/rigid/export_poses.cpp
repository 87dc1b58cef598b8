// SPDX-License-Identifier: Apache-2.0
#include "export/rigid/export_poses.h"

#include <algorithm>
#include <random>

namespace handsight {
namespace {

constexpr std::size_t most_measured = 300, drawn_poses = 50, most_between = 100;

double drawn(double lowest, double highest, std::mt19937_64& random) {
  return std::uniform_real_distribution<double>(lowest, highest)(random);
}

/// Within the joint's limits, and not far from its zero.
double drawn_value(const Joint& joint, std::mt19937_64& random) {
  const double widest = joint.kind == JointKind::prismatic ? 0.3 : 1.5;  // m, rad
  const double lower = std::clamp(-widest, joint.lower, joint.upper),
               upper = std::clamp(widest, joint.lower, joint.upper);
  return lower < upper ? drawn(lower, upper, random) : lower;
}

std::vector<Eigen::VectorXd> drawn_positions(const Chain& chain, std::mt19937_64& random) {
  std::vector<Eigen::VectorXd> all;
  for (std::size_t i = 0; i < drawn_poses; ++i) {
    Eigen::VectorXd& position = all.emplace_back(static_cast<Eigen::Index>(chain.joints.size()));
    for (Eigen::Index j = 0; j < position.size(); ++j) {
      const int joint = chain.joints[static_cast<std::size_t>(j)];
      position[j] = drawn_value(chain.robot.joints[static_cast<std::size_t>(joint)], random);
    }
  }
  return all;
}

std::vector<Eigen::VectorXd> spread(const std::vector<Eigen::VectorXd>& all) {
  if (all.size() <= most_measured) return all;
  std::vector<Eigen::VectorXd> some;
  for (std::size_t i = 0; i < most_measured; ++i) some.push_back(all[i * all.size() / most_measured]);
  return some;
}

}  // namespace

ExportPoses export_poses(const CalibratedRobot& robot) {
  std::mt19937_64 random(17);
  ExportPoses poses;
  poses.are_measured = !robot.positions.empty();
  const std::vector<Eigen::VectorXd> positions =
      poses.are_measured ? spread(robot.positions) : drawn_positions(robot.chain, random);
  std::vector<DrivenPose> driven;
  for (const Eigen::VectorXd& p : positions) driven.push_back({p, {}, {}});
  poses.measured = states_at(robot.chain, driven);
  for (std::size_t i = 0; i < std::min(most_between, 3 * positions.size()); ++i) {
    const auto a = random() % positions.size();
    const auto b = random() % positions.size();
    const double share = drawn(0, 1, random);
    poses.between.push_back(
        states_at(robot.chain, Eigen::VectorXd(positions[a] + share * (positions[b] - positions[a]))));
  }
  return poses;
}

}  // namespace handsight
