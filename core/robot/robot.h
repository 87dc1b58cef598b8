// SPDX-License-Identifier: Apache-2.0
// A robot as its URDF describes it: links, joints, masses. Read-only once made.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "geometry/rigid.h"

namespace handsight {

enum class ShapeKind { box, cylinder, sphere, mesh };

/// A shape to draw a link with: box (size x y z), cylinder (radius, length along z), sphere (radius), or mesh.
struct Shape {
  ShapeKind kind = ShapeKind::box;
  Vector3 size = Vector3::Zero();  // m: box x, y, z; cylinder radius, length, 0; sphere radius, 0, 0; mesh scale
  std::string mesh_file;           // as the URDF writes it
  Rigid link_from_shape;
  std::optional<Eigen::Vector4d> color;  // red, green, blue, alpha, 0 to 1
};

struct Link {
  std::string name;
  double mass = 0;                           // kg
  Vector3 center_of_mass = Vector3::Zero();  // m, in the link's frame
  std::vector<Shape> shapes;
  int parent_joint = -1;  // the joint that carries it; -1 for the root
};

enum class JointKind { fixed, revolute, continuous, prismatic };

/// One contribution to a mimic joint: multiplier * angle of `joint`.
struct Mimic {
  int joint = -1;
  double multiplier = 1;
  double offset = 0;  // rad or m
};

/// parent_from_child(q) = parent_from_joint * motion(axis, q) * joint_from_child. The joint's frame is the one
/// before its motion; its origin and axis are where moments are taken. joint_from_child is the identity except for
/// Denavit-Hartenberg joints, where it is Rz(theta) Tz(d).
struct Joint {
  std::string name;
  JointKind kind = JointKind::fixed;
  int parent_link = -1;
  int child_link = -1;
  Rigid parent_from_joint;
  Vector3 axis = Vector3::UnitX();  // unit, in the joint's frame
  Rigid joint_from_child;
  double lower = -1e30, upper = 1e30;  // rad or m; continuous joints and joints without limits have none
  std::vector<Mimic> mimics;           // empty: moved by itself
  double stiffness = 0;                // N m/rad (N/m), 0: rigid; its deflection is part of the nominal model

  bool moves() const { return kind != JointKind::fixed; }
  bool is_mimic() const { return !mimics.empty(); }
};

/// A tree of links: parents come before their children, in `links` as in `joints`; links[0] is the root.
struct Robot {
  std::string name;
  std::vector<Link> links;
  std::vector<Joint> joints;
  bool is_of_poses = false;  // poses_robot: its joints stand for a pose, not for joints of a robot
};

/// A robot of which only the flange's pose is known: links "base" and "flange" with six joints between, whose values
/// are x, y, z (m), yaw, pitch, roll (rad, XYZ fixed angles) of base_from_flange.
Robot poses_robot();

/// Those values, and back.
Rigid base_from_flange(const Eigen::VectorXd& position);
Eigen::Matrix<double, 6, 1> make_position(const Rigid& base_from_flange);

/// The links of a robot that can be the TCP or carry the cameras, and the joints that a position names: those that
/// move and mimic no other.
std::vector<std::string> link_names(const Robot& robot);
std::vector<std::string> joint_names(const Robot& robot);

/// Index of the link or joint of that name, -1 where there is none.
int find_link(const Robot& robot, const std::string& name);
int find_joint(const Robot& robot, const std::string& name);

/// The joints from the root to a link, root first, fixed ones included.
std::vector<int> joints_to(const Robot& robot, int link);

/// Is `link` moved by `joint` (the joint's child or anything below it)?
bool is_distal(const Robot& robot, int joint, int link);

}  // namespace handsight
