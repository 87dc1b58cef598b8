// SPDX-License-Identifier: Apache-2.0
#include "robot/posture_tangent.h"

#include <ceres/jet.h>
#include <gtest/gtest.h>

#include <random>

#include "fixtures/arms.h"
#include "fixtures/drawn.h"

namespace handsight {
namespace {

using Jet = ceres::Jet<double, 1>;

struct Arm {
  Robot robot;
  int moved, reference;
};

/// The torso with a linkage, two branches, a sliding joint, masses on fixed links; every spring there is.
Arm branched_robot(bool elastic) {
  Robot r = fixture::coupled_torso();
  r.links.push_back(fixture::make_link("head", 2.5, {0.02, -0.1, 0.05}, 5));
  Joint neck = fixture::make_joint("neck", 3, 6, {0.2, 0.05, 0}, {0.2, 0.1, -0.3}, {0.1, 0.9, 0.3});
  neck.kind = JointKind::prismatic;
  r.joints.push_back(neck);
  r.links.push_back(fixture::make_link("camera", 0.4, {0.02, -0.1, 0.05}, 6));
  Joint tilt = fixture::make_joint("tilt", 6, 7, {0.2, 0.05, 0.1}, {0.2, 0.1, -0.3}, {0, 1, 0});
  r.joints.push_back(tilt);
  r.links.push_back(fixture::make_link("tool", 0.9, {0.02, 0.03, 0.05}, 7));
  Joint fixed = fixture::make_joint("flange", 5, 8, {0.1, 0, 0.02}, {0.5, 0, 0}, {1, 0, 0});
  fixed.kind = JointKind::fixed;
  r.joints.push_back(fixed);
  r.links.push_back(fixture::make_link("battery", 7, {0.1, 0.2, -0.1}, 8));
  Joint bolt = fixture::make_joint("bolt", 0, 9, {0.1, 0, 0.02}, {0.5, 0, 0}, {1, 0, 0});
  bolt.kind = JointKind::fixed;
  r.joints.push_back(bolt);
  r.links[0].mass = 3;
  r.links[0].center_of_mass = {0.1, 0.05, 0.2};
  if (elastic)
    for (std::size_t j = 0; j < r.joints.size(); ++j)
      if (j % 2 == 0) r.joints[j].stiffness = 2000.0 + 500.0 * static_cast<double>(j);
  return {r, 8, 7};
}

RobotChange random_change(const Robot& robot, std::mt19937_64& random, double size) {
  std::normal_distribution<double> normal(0, size);
  RobotChange c;
  c.joints.resize(robot.joints.size());
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    JointChange& one = c.joints[j];
    one.angle = normal(random);
    one.frame = Vector6::NullaryExpr([&] { return normal(random); });
    one.after = Vector6::NullaryExpr([&] { return normal(random); });
    one.compliance = 2e-3 * std::abs(normal(random));
    one.lateral_compliance = 1e-3 * std::abs(normal(random));
    one.gap = 0.1 * normal(random);
    if (robot.joints[j].is_mimic()) {
      one.multiplier_error = normal(random);
      one.share = 5 * normal(random);
    }
  }
  c.tilt_x = normal(random);
  c.tilt_y = normal(random);
  c.base_compliance = 1e-3 * fixture::drawn_3([&] { return normal(random); });
  c.payload_link = 5;
  c.payload_mass = normal(random);
  c.payload_moment = fixture::drawn_3([&] { return normal(random); });
  return c;
}

/// Every number of a change in turn, by reference.
template <class T, class Visit>
void visit_numbers(RobotChangeT<T>& c, Visit&& visit) {
  for (std::size_t j = 0; j < c.joints.size(); ++j) {
    JointChangeT<T>& one = c.joints[j];
    const std::string joint = "joint " + std::to_string(j) + " ";
    visit(one.angle, joint + "angle");
    visit(one.multiplier_error, joint + "multiplier");
    visit(one.share, joint + "share");
    for (int k = 0; k < 6; ++k) visit(one.frame[k], joint + "frame " + std::to_string(k));
    for (int k = 0; k < 6; ++k) visit(one.after[k], joint + "after " + std::to_string(k));
    visit(one.compliance, joint + "compliance");
    visit(one.lateral_compliance, joint + "lateral");
    visit(one.gap, joint + "gap");
  }
  visit(c.tilt_x, "tilt x");
  visit(c.tilt_y, "tilt y");
  for (int k = 0; k < 3; ++k) visit(c.base_compliance[k], "base " + std::to_string(k));
  visit(c.payload_mass, "mass");
  for (int k = 0; k < 3; ++k) visit(c.payload_moment[k], "moment " + std::to_string(k));
}

RobotChangeT<Jet> as_jets(const RobotChange& c) {
  RobotChangeT<Jet> jets;
  jets.joints.resize(c.joints.size());
  jets.payload_link = c.payload_link;
  std::vector<double> numbers;
  RobotChange copy = c;
  visit_numbers(copy, [&](double& x, const std::string&) { numbers.push_back(x); });
  std::size_t i = 0;
  visit_numbers(jets, [&](Jet& x, const std::string&) { x = Jet(numbers[i++]); });
  return jets;
}

/// The relative motion of the two links by Ceres's automatic differentiation through the equilibrium.
Vector6 motion_by_jets(const Arm& arm, const Eigen::VectorXd& q, const RobotChangeT<Jet>& change, const Vector3& g) {
  const PostureT<Jet> p = solve_posture<Jet>(arm.robot, q, change, g);
  EXPECT_TRUE(p.converged);
  auto make_motion = [&](int link) {
    const RigidT<Jet>& pose = p.root_from_link[static_cast<std::size_t>(link)];
    Matrix3 r, dr;
    Vector3 t, dt;
    for (int i = 0; i < 3; ++i) {
      t[i] = pose.translation[i].a;
      dt[i] = pose.translation[i].v[0];
      for (int j = 0; j < 3; ++j) {
        r(i, j) = pose.rotation(i, j).a;
        dr(i, j) = pose.rotation(i, j).v[0];
      }
    }
    const Matrix3 w = dr * r.transpose();
    Vector6 motion;
    const Vector3 turn(w(2, 1), w(0, 2), w(1, 0));
    motion << dt - turn.cross(t), turn;
    return motion;
  };
  return make_motion(arm.moved) - make_motion(arm.reference);
}

void expect_all_numbers_agree(const Arm& arm, const RobotChange& change, const Eigen::VectorXd& q) {
  const Vector3 gravity(0.3, -0.2, -9.7);
  const Posture posture = solve_posture<double>(arm.robot, q, change, gravity);
  ASSERT_TRUE(posture.converged);
  const PostureTangent tangent(arm.robot, change, gravity, posture, arm.moved, arm.reference);
  RobotChange direction;
  direction.joints.resize(arm.robot.joints.size());
  direction.payload_link = change.payload_link;
  std::size_t number = 0;
  visit_numbers(direction, [&](double& one, const std::string& name) {
    // A derivative by 1 rad/(N m) is huge, and solve_posture takes what grows beyond bounds for unstable.
    const bool soft = name.find("compliance") != std::string::npos || name.find("lateral") != std::string::npos;
    const double seed = soft || name.find("base") == 0 ? 1e-2 : 1;
    RobotChangeT<Jet> jets = as_jets(change);
    std::size_t i = 0;
    visit_numbers(jets, [&](Jet& x, const std::string&) {
      if (i++ == number) x.v[0] = seed;
    });
    ++number;
    if (name.rfind("joint", 0) == 0) {
      const auto j = static_cast<std::size_t>(std::stoi(name.substr(6)));
      if (!arm.robot.joints[j].moves()) return;  // no effect acts at a fixed joint
    }
    one = 1;
    const Vector6 ours = tangent.motion(direction);
    one = 0;
    const Vector6 theirs = motion_by_jets(arm, q, jets, gravity) / seed;
    EXPECT_LT((ours - theirs).norm(), 1e-8 * (1 + theirs.norm()))
        << name << "\nours   " << ours.transpose() << "\ntheirs " << theirs.transpose();
  });
}

Eigen::VectorXd pose(const Robot& robot, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(-1.2, 1.2);
  return Eigen::VectorXd::NullaryExpr(static_cast<Eigen::Index>(robot.joints.size()), [&] { return uniform(random); });
}

/// Where everything is changed at random: the posture is drawn first.
void expect_all_numbers_agree(const Arm& arm, std::mt19937_64& random) {
  const Eigen::VectorXd q = pose(arm.robot, random);
  expect_all_numbers_agree(arm, random_change(arm.robot, random, 0.03), q);
}

TEST(PostureTangent, AgreesWithJetsWhereEverythingIsChanged) {
  std::mt19937_64 random(3);
  for (int trial = 0; trial < 5; ++trial) {
    const Arm arm = branched_robot(true);
    expect_all_numbers_agree(arm, random);
  }
}

TEST(PostureTangent, AgreesWithJetsAtTheNominalRobot) {
  std::mt19937_64 random(4);
  for (const bool elastic : {false, true}) {
    const Arm arm = branched_robot(elastic);
    RobotChange none;
    none.joints.resize(arm.robot.joints.size());
    none.payload_link = 5;
    expect_all_numbers_agree(arm, none, pose(arm.robot, random));
  }
}

TEST(PostureTangent, AgreesWithJetsForAHandSeenFromTheFloor) {
  std::mt19937_64 random(5);
  Arm arm = branched_robot(true);
  arm.reference = 0;
  expect_all_numbers_agree(arm, random);
}

TEST(PostureTangent, TheOrderOfAMimicJointDoesNotMatter) {
  std::mt19937_64 random(6);
  Arm arm = branched_robot(true);
  arm.robot.joints[0].mimics = {{1, 0.5, 0.1}, {4, -0.7, 0.0}};  // follows joints after it
  arm.robot.joints[2].mimics = {{0, -1, 0}};                     // a mimic of a mimic
  expect_all_numbers_agree(arm, random);
}

}  // namespace
}  // namespace handsight
