// SPDX-License-Identifier: Apache-2.0
#include "robot/posture.h"

#include <gtest/gtest.h>

#include <random>

#include "fixtures/arms.h"

namespace handsight {
namespace {

const Vector3 down(0, 0, -9.81);

Eigen::VectorXd random_position(int count, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(-1.5, 1.5);
  return Eigen::VectorXd::NullaryExpr(count, [&] { return uniform(random); });
}

/// Potential energy of gravity: the independent authority for torques.
double potential(const Robot& robot, const Posture& posture) {
  double energy = 0;
  for (std::size_t l = 0; l < robot.links.size(); ++l)
    energy -= robot.links[l].mass * down.dot(posture.root_from_link[l] * robot.links[l].center_of_mass);
  return energy;
}

TEST(Posture, AtZeroTheArmStandsAsDrawn) {
  const Robot robot = fixture::six_axis_arm();
  const Posture p = solve_posture(robot, Eigen::VectorXd::Zero(6), down);
  EXPECT_LT((p.root_from_link[6].translation - Vector3(0.05 + 0.15 + 0.25 + 0.08, 0, 0.2 + 0.2 + 0.4 + 0.03)).norm(),
            1e-15);
}

TEST(Posture, TorquesAreMinusTheSlopeOfThePotential) {
  const Robot robot = fixture::six_axis_arm();
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 20; ++trial) {
    const Eigen::VectorXd q = random_position(6, random);
    const Posture p = solve_posture(robot, q, down);
    for (int j = 0; j < 6; ++j) {
      Eigen::VectorXd more = q, less = q;
      more[j] += 1e-6;
      less[j] -= 1e-6;
      const double slope =
          (potential(robot, solve_posture(robot, more, down)) - potential(robot, solve_posture(robot, less, down))) /
          2e-6;
      EXPECT_NEAR(p.torque[static_cast<std::size_t>(j)], -slope, 1e-6);
    }
  }
}

TEST(Posture, PrismaticTorqueIsTheForceAlongTheAxis) {
  Robot robot = fixture::six_axis_arm();
  robot.joints[2].kind = JointKind::prismatic;
  robot.joints[2].axis = Vector3(0, 0, 1);
  std::mt19937_64 random(2);
  const Eigen::VectorXd q = random_position(6, random);
  const Posture p = solve_posture(robot, q, down);
  Eigen::VectorXd more = q;
  more[2] += 1e-4;
  const Posture further = solve_posture(robot, more, down);
  const double force = -(potential(robot, further) - potential(robot, p)) / 1e-4;
  EXPECT_NEAR(p.torque[2], force, 1e-8);
}

TEST(Posture, MimicJointsFollowTheirSum) {
  const Robot robot = fixture::coupled_torso();
  Eigen::VectorXd position(4);
  position << 0.3, -0.7, 0.2, 0.1;
  const Eigen::VectorXd q = joint_values(robot, {0, 1, 3, 4}, position);
  EXPECT_NEAR(q[2], -(0.3 - 0.7), 1e-15);
  const Posture p = solve_posture(robot, q, down);
  // The chest stays upright: the three rotations about the same axis cancel.
  EXPECT_LT((p.root_from_link[3].rotation - robot.joints[0].parent_from_joint.rotation).norm(), 1e-14);
}

TEST(Equilibrium, EverySpringCarriesItsLoadTo1e9Rad) {
  Robot robot = fixture::six_axis_arm();
  for (Joint& joint : robot.joints) joint.stiffness = 800;  // soft: up to 10 degrees
  std::mt19937_64 random(3);
  for (int trial = 0; trial < 20; ++trial) {
    const Eigen::VectorXd q = random_position(6, random);
    const Posture p = solve_posture(robot, q, down);
    ASSERT_TRUE(p.converged);
    for (std::size_t j = 0; j < 6; ++j)
      EXPECT_NEAR(p.value[j] - q[static_cast<Eigen::Index>(j)], p.torque[j] / 800, 1e-9);
  }
}

TEST(Equilibrium, GivesWayToGravity) {
  Robot robot = fixture::six_axis_arm();
  Eigen::VectorXd q = Eigen::VectorXd::Zero(6);
  q[1] = 1.2;  // stretched forward
  const double rigid = solve_posture(robot, q, down).root_from_link[6].translation.z();
  robot.joints[1].stiffness = 5000;
  EXPECT_LT(solve_posture(robot, q, down).root_from_link[6].translation.z(), rigid - 1e-3);
}

TEST(Equilibrium, IsStationaryInTotalEnergy) {
  // Springs and gravity together: no small change of a joint lowers the energy to first order.
  Robot robot = fixture::six_axis_arm();
  for (Joint& joint : robot.joints) joint.stiffness = 3000;
  std::mt19937_64 random(4);
  const Eigen::VectorXd q = random_position(6, random);
  const Posture p = solve_posture(robot, q, down);
  Robot rigid = fixture::six_axis_arm();
  auto energy = [&](const Eigen::VectorXd& values) {
    double springs = 0;
    for (int j = 0; j < 6; ++j) springs += 0.5 * 3000 * std::pow(values[j] - q[j], 2);
    return springs + potential(rigid, solve_posture(rigid, values, down));
  };
  const Eigen::VectorXd at = Eigen::Map<const Eigen::VectorXd>(p.value.data(), 6);
  for (int j = 0; j < 6; ++j) {
    Eigen::VectorXd more = at, less = at;
    more[j] += 1e-5;
    less[j] -= 1e-5;
    EXPECT_NEAR((energy(more) - energy(less)) / 2e-5, 0, 1e-5);
  }
}

TEST(Equilibrium, ALinkageCarriesTheMimicJointsLoadToItsMotors) {
  // Fully held (share 1): by virtual work the motors of t1 and t2 see the potential with the chest kept upright.
  const Robot robot = fixture::coupled_torso();
  RobotChange change;
  change.joints.resize(robot.joints.size());
  for (const std::size_t j : {0u, 1u}) change.joints[j].compliance = 1e-4;
  change.joints[2].share = 1;
  Eigen::VectorXd position(4);
  position << 0.5, 0.4, -0.3, 0.6;
  const Eigen::VectorXd q = joint_values(robot, {0, 1, 3, 4}, position);
  const Posture p = solve_posture<double>(robot, q, change, down);
  auto energy = [&](double t1, double t2) {
    Eigen::VectorXd moved = position;
    moved[0] = t1;
    moved[1] = t2;
    const double springs = 0.5 * 1e4 * (std::pow(t1 - 0.5, 2) + std::pow(t2 - 0.4, 2));
    return springs + potential(robot, solve_posture(robot, joint_values(robot, {0, 1, 3, 4}, moved), down));
  };
  EXPECT_NEAR(p.value[2], -p.value[0] - p.value[1], 1e-12);
  EXPECT_NEAR((energy(p.value[0] + 1e-5, p.value[1]) - energy(p.value[0] - 1e-5, p.value[1])) / 2e-5, 0, 1e-4);
  EXPECT_NEAR((energy(p.value[0], p.value[1] + 1e-5) - energy(p.value[0], p.value[1] - 1e-5)) / 2e-5, 0, 1e-4);
}

TEST(Equilibrium, SaysWhenASpringIsTooSoft) {
  Robot robot = fixture::six_axis_arm();
  robot.joints[1].stiffness = 1;
  Eigen::VectorXd q = Eigen::VectorXd::Zero(6);
  q[1] = 1.2;
  EXPECT_FALSE(solve_posture(robot, q, down).converged);
}

}  // namespace
}  // namespace handsight
