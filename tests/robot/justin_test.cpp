// SPDX-License-Identifier: Apache-2.0
// resources/justin.urdf against the Denavit-Hartenberg table that it was written from.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "robot/posture.h"
#include "robot/urdf.h"

namespace handsight {
namespace {

constexpr double degree = std::numbers::pi / 180;

const Robot& justin() {
  static const Robot robot = read_urdf(std::string(HANDSIGHT_SOURCE_DIR) + "/resources/justin.urdf");
  return robot;
}

using Angles = std::map<std::string, double>;

Posture posture_at(const Angles& angles) {
  std::vector<int> joints;
  Eigen::VectorXd values(static_cast<Eigen::Index>(angles.size()));
  for (const auto& [name, angle] : angles) {
    values[static_cast<Eigen::Index>(joints.size())] = angle;
    joints.push_back(find_joint(justin(), name));
    EXPECT_GE(joints.back(), 0) << name;
  }
  return solve_posture(justin(), joint_values(justin(), joints, values), Vector3(0, 0, -9.81));
}

Rigid link_frame(const Posture& posture, const std::string& link) {
  const int index = find_link(justin(), link);
  EXPECT_GE(index, 0) << link;
  return posture.root_from_link.at(static_cast<std::size_t>(index));
}

// The table, written a second time as plain 4 x 4 matrices: d (m), theta0 (deg), a (m), alpha (deg).
struct Row {
  double d, theta, a, alpha;
};

Matrix4 dh(const Row& row, double q) {
  const double c = std::cos(row.theta * degree + q), s = std::sin(row.theta * degree + q);
  const double ca = std::cos(row.alpha * degree), sa = std::sin(row.alpha * degree);
  Matrix4 m;
  m << c, -s, 0, row.a,                  //
      ca * s, ca * c, -sa, -row.d * sa,  //
      sa * s, sa * c, ca, row.d * ca,    //
      0, 0, 0, 1;
  return m;
}

Matrix4 docking(const Matrix3& rotation, const Vector3& translation) {
  Matrix4 m = Matrix4::Identity();
  m.topLeftCorner<3, 3>() = rotation;
  m.topRightCorner<3, 1>() = translation;
  return m;
}

std::map<std::string, Matrix4> frames_from_table(const Angles& q) {
  std::map<std::string, Matrix4> frames;
  const double root3 = std::sqrt(3.0) / 2;
  const Row torso[] = {{0.1055, 0, 0, 0}, {0, -90, 0, -90}, {0, 0, 0.3, 0}, {0, 0, 0.3, 0}};
  const double torso_angles[] = {q.at("torso_1"), q.at("torso_2"), q.at("torso_3"), -q.at("torso_2") - q.at("torso_3")};
  Matrix4 chest = Matrix4::Identity();
  for (int i = 0; i < 4; ++i) {
    chest = chest * dh(torso[i], torso_angles[i]);
    frames[i == 3 ? "chest" : "torso_" + std::to_string(i + 1)] = chest;
  }
  Matrix3 right, left, head, hand, tip;
  right << -root3, 0, 0.5, 0, 1, 0, -0.5, 0, -root3;
  left << root3, 0, 0.5, 0, 1, 0, -0.5, 0, root3;
  head << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  hand << -1, 0, 0, 0, 0, 1, 0, 1, 0;
  tip << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  const Row right_arm[] = {{0, 0, 0, 0},         {0, 0, 0, 90},  {0.4, -90, 0, -90}, {0, 0, 0, 90},
                           {0.39, -180, 0, -90}, {0, 90, 0, 90}, {0, -90, 0, 90}};
  const Row left_arm[] = {{0, 0, 0, 180},     {0, 0, 0, 90},   {-0.4, -90, 0, -90}, {0, 0, 0, 90},
                          {-0.39, 0, 0, -90}, {0, 90, 0, -90}, {0, -90, 0, -90}};
  for (const std::string side : {"right", "left"}) {
    Matrix4 frame =
        chest * (side == "right" ? docking(right, {0.19, 0.088, -0.256}) : docking(left, {0.19, 0.088, 0.256}));
    frames[side + "_arm_base"] = frame;
    for (int i = 0; i < 7; ++i) {
      const std::string name = side + "_arm_" + std::to_string(i + 1);
      frame = frame * dh(side == "right" ? right_arm[i] : left_arm[i], q.at(name));
      frames[name] = frame;
    }
    frames[side + "_hand"] = frame * docking(hand, {0, 0.118, 0});
  }
  frames["head_base"] = chest * docking(head, {0.235, 0.088, 0});
  frames["head_pan"] = frames["head_base"] * dh({0, 0, 0, 0}, q.at("head_pan"));
  frames["head_tilt"] = frames["head_pan"] * dh({0, 0, 0, -90}, q.at("head_tilt"));
  frames["head_tcp"] = frames["head_tilt"] * docking(tip, Vector3::Zero());
  return frames;
}

std::vector<std::string> moved_joints() {
  std::vector<std::string> names;
  for (const Joint& joint : justin().joints)
    if (joint.moves() && !joint.is_mimic()) names.push_back(joint.name);
  return names;
}

TEST(Justin, HasNineteenMotorsAndOnePassiveJoint) {
  EXPECT_EQ(moved_joints().size(), 19u);
  const Joint& passive = justin().joints.at(static_cast<std::size_t>(find_joint(justin(), "torso_4")));
  ASSERT_EQ(passive.mimics.size(), 2u);
  EXPECT_EQ(passive.mimics[0].joint, find_joint(justin(), "torso_2"));
  EXPECT_EQ(passive.mimics[1].joint, find_joint(justin(), "torso_3"));
  for (const Mimic& mimic : passive.mimics) EXPECT_EQ(mimic.multiplier, -1);
  for (const Joint& joint : justin().joints) EXPECT_EQ(joint.stiffness, 0) << joint.name;
  EXPECT_EQ(justin().links[0].name, "base");
}

TEST(Justin, FramesAtZeroAreThePublishedOnes) {
  const Posture posture = posture_at({});
  const auto expect = [&](const std::string& link, const Vector3& place) {
    EXPECT_LT((link_frame(posture, link).translation - place).norm(), 1e-6) << link;
  };
  expect("chest", {0, 0, 0.7055});
  expect("right_arm_base", {0.088, -0.256, 0.8955});
  expect("left_arm_base", {0.088, 0.256, 0.8955});
  const double reach = 0.256 + 0.908 * std::sqrt(3.0) / 2;  // published as 1.04235
  EXPECT_NEAR(reach, 1.04235, 2e-6);
  expect("right_hand", {0.088, -reach, 1.3495});
  expect("left_hand", {0.088, reach, 1.3495});
  expect("head_base", {0.088, 0, 0.9405});
  expect("head_tcp", {0.088, 0, 0.9405});
  // The head looks forward, z up.
  EXPECT_LT((link_frame(posture, "head_tcp").rotation - Matrix3::Identity()).norm(), 1e-12);
}

TEST(Justin, FramesAreThoseOfTheTableInAnyPosture) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> share(0, 1);
  for (int trial = 0; trial < 20; ++trial) {
    Angles angles;
    for (const std::string& name : moved_joints()) {
      const Joint& joint = justin().joints.at(static_cast<std::size_t>(find_joint(justin(), name)));
      angles[name] = joint.lower + share(random) * (joint.upper - joint.lower);
    }
    const Posture posture = posture_at(angles);
    for (const auto& [link, frame] : frames_from_table(angles))
      EXPECT_LT((matrix_from_rigid(link_frame(posture, link)) - frame).norm(), 1e-12) << link << ", trial " << trial;
  }
}

TEST(Justin, TheChestStaysUpright) {
  const Rigid upright = link_frame(posture_at({}), "chest");
  const Rigid bent = link_frame(posture_at({{"torso_2", 0.7}, {"torso_3", 0.4}}), "chest");
  EXPECT_LT((bent.rotation - upright.rotation).norm(), 1e-12);
}

TEST(Justin, MassesAddUpToThePublishedSums) {
  const auto sum = [&](const std::string& start) {
    double mass = 0;
    for (const Link& link : justin().links)
      if (link.name.rfind(start, 0) == 0) mass += link.mass;
    return mass;
  };
  EXPECT_NEAR(sum("torso") + sum("chest"), 18.8, 0.01);
  EXPECT_NEAR(sum("right_arm"), 12.82, 0.01);
  EXPECT_NEAR(sum("left_arm"), 12.82, 0.01);
  EXPECT_EQ(sum("right_hand"), 2.0);
  EXPECT_EQ(sum("left_hand"), 2.0);
  EXPECT_EQ(sum("head"), 3.0);
  EXPECT_NEAR(sum(""), 51.45, 0.01);
}

TEST(Justin, LimitsAreThePublishedOnes) {
  const auto expect = [&](const std::string& name, double lower, double upper) {
    const Joint& joint = justin().joints.at(static_cast<std::size_t>(find_joint(justin(), name)));
    EXPECT_NEAR(joint.lower, lower * degree, 1e-12) << name;
    EXPECT_NEAR(joint.upper, upper * degree, 1e-12) << name;
  };
  expect("torso_1", -120, 120);
  expect("torso_2", -90, 90);
  expect("torso_3", 0, 135);
  expect("right_arm_4", -120, 120);
  expect("left_arm_6", -45.1, 80);
  expect("left_arm_7", -45, 135);
  expect("head_pan", -45.2, 45.2);
  expect("head_tilt", -22.5, 45);
}

TEST(Justin, EveryLimbHasAShape) {
  for (const char* link : {"base", "torso_1", "torso_2", "torso_3", "chest", "right_arm_2", "left_arm_2", "right_arm_5",
                           "left_arm_5", "right_hand", "left_hand", "head_tcp"}) {
    const Link& shown = justin().links.at(static_cast<std::size_t>(find_link(justin(), link)));
    EXPECT_FALSE(shown.shapes.empty()) << link;
    for (const Shape& shape : shown.shapes) EXPECT_TRUE(shape.color.has_value()) << link;
  }
}

}  // namespace
}  // namespace handsight
