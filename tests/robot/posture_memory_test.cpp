// SPDX-License-Identifier: Apache-2.0
#include "robot/posture_memory.h"

#include <gtest/gtest.h>

#include <random>

#include "fixtures/arms.h"

namespace handsight {
namespace {

const Vector3 down_z(0, 0, -9.81);

/// Springs along and across every axis, a base that gives way, joints' frames that are moved and play.
RobotChange random_change(const Robot& robot, double softness, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  RobotChange change;
  change.joints.resize(robot.joints.size());
  for (JointChange& c : change.joints) {
    c.compliance = softness * std::abs(normal(random));
    c.lateral_compliance = 0.3 * softness * std::abs(normal(random));
    c.gap = 1e-3 * normal(random);
    c.angle = 1e-2 * normal(random);
    c.frame = Vector6::NullaryExpr([&] { return 1e-2 * normal(random); });
    if (normal(random) > 0) c.after = Vector6::NullaryExpr([&] { return 1e-2 * normal(random); });
  }
  change.base_compliance = softness * Vector3(1, 0.2, 0.7);
  return change;
}

double largest_difference(const Posture& a, const Posture& b) {
  double largest = posture_detail::largest_change(a.deflection, b.deflection);
  for (std::size_t l = 0; l < a.root_from_link.size(); ++l) {
    largest = std::max(largest, (a.root_from_link[l].translation - b.root_from_link[l].translation).norm());
    largest = std::max(largest, (a.root_from_link[l].rotation - b.root_from_link[l].rotation).norm());
  }
  for (std::size_t j = 0; j < a.torque.size(); ++j) largest = std::max(largest, std::abs(a.torque[j] - b.torque[j]));
  return largest;
}

TEST(PostureMemory, IsAtTheEquilibriumOfEveryPostureInFewerPasses) {
  const Robot robot = fixture::six_axis_arm();
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(-1.5, 1.5);
  PostureMemory memory;
  int passes = 0, plain_passes = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const RobotChange change = random_change(robot, trial % 3 == 0 ? 0 : 3e-4, random);
    const Eigen::VectorXd q = Eigen::VectorXd::NullaryExpr(6, [&] { return uniform(random); });
    const Posture expected = solve_posture<double>(robot, q, change, down_z);
    const Posture& p = memory.solve(robot, q, change, down_z);
    EXPECT_EQ(p.converged, expected.converged);
    EXPECT_LT(largest_difference(p, expected), 1e-8) << trial;  // N m too, of some 10 N m
    passes += p.iterations;
    plain_passes += expected.iterations;
  }
  EXPECT_LT(passes, 0.9 * plain_passes);
}

TEST(PostureMemory, SpringsThatCannotHoldHaveNoEquilibrium) {
  const Robot robot = fixture::six_axis_arm();
  std::mt19937_64 random(8);
  const Eigen::VectorXd q = Eigen::VectorXd::Constant(6, 0.4);
  RobotChange soft;
  soft.joints.resize(robot.joints.size());
  for (JointChange& c : soft.joints) c.compliance = 1;  // rad/(N m)
  PostureMemory memory;
  ASSERT_FALSE(solve_posture<double>(robot, q, soft, down_z).converged);
  EXPECT_FALSE(memory.solve(robot, q, soft, down_z).converged);
  const RobotChange change = random_change(robot, 3e-4, random);
  const Posture expected = solve_posture<double>(robot, q, change, down_z);
  EXPECT_LT(largest_difference(memory.solve(robot, q, change, down_z), expected), 1e-8);
}

/// A joint that gravity hardly turns rests between the flanks of its play, where plain passes throw it from one to the
/// other for ever.
TEST(PostureMemory, PlayThatThrowsPassesToAndFroHasItsEquilibrium) {
  const Robot robot = fixture::six_axis_arm();
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> uniform(-3, 3);
  PostureMemory memory;
  int thrown = 0;
  for (const double gap : {3e-3, 1e-2, 3e-2})
    for (int trial = 0; trial < 2000; ++trial) {
      RobotChange change;
      change.joints.resize(robot.joints.size());
      change.joints[1].gap = gap;
      const Eigen::VectorXd q = Eigen::VectorXd::NullaryExpr(6, [&] { return uniform(random); });
      const Posture& p = memory.solve(robot, q, change, down_z);
      ASSERT_TRUE(p.converged) << gap << ' ' << trial;
      EXPECT_NEAR(p.value[1] - q[1], gap * std::tanh(p.torque[1] / posture_detail::backlash_torque), 1e-9) << trial;
      thrown += solve_posture<double>(robot, q, change, down_z).converged ? 0 : 1;
    }
  EXPECT_GT(thrown, 20);
}

TEST(PostureMemory, WhatHasNoEquilibriumIsSoonGivenUp) {
  const Robot robot = fixture::six_axis_arm();
  std::mt19937_64 random(10);
  std::uniform_real_distribution<double> uniform(-1.5, 1.5);
  PostureMemory memory;
  for (int trial = 0; trial < 60; ++trial) {
    const RobotChange change = random_change(robot, 0.3, random);
    const Eigen::VectorXd q = Eigen::VectorXd::NullaryExpr(6, [&] { return uniform(random); });
    const Posture& p = memory.solve(robot, q, change, down_z);
    if (!p.converged) EXPECT_LT(p.iterations, 200) << trial;
  }
}

/// One memory for robots in turn: the other's joints are not taken for its own.
TEST(PostureMemory, ServesOneRobotAfterAnother) {
  const Robot robot = fixture::six_axis_arm();
  Robot longer = robot;
  longer.joints[2].parent_from_joint.translation.z() += 0.1;
  const Eigen::VectorXd q = Eigen::VectorXd::Constant(6, 0.4);
  PostureMemory memory;
  for (const Robot* r : std::initializer_list<const Robot*>{&robot, &longer, &robot})
    EXPECT_LT(largest_difference(memory.solve(*r, q, {}, down_z), solve_posture(*r, q, down_z)), 1e-12);
}

}  // namespace
}  // namespace handsight
