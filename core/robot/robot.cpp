// SPDX-License-Identifier: Apache-2.0
#include "robot/robot.h"

#include <algorithm>

namespace handsight {

Robot poses_robot() {
  constexpr const char* names[] = {"flange_x", "flange_y", "flange_z", "flange_yaw", "flange_pitch", "flange_roll"};
  Robot robot;
  robot.name = "poses";
  robot.is_of_poses = true;
  robot.links.push_back(Link{.name = "base"});
  for (int j = 0; j < 6; ++j) {
    Joint joint;
    joint.name = names[j];
    joint.kind = j < 3 ? JointKind::prismatic : JointKind::continuous;
    joint.parent_link = j;
    joint.child_link = j + 1;
    joint.axis = Vector3::Unit(j < 3 ? j : 5 - j);
    robot.joints.push_back(joint);
    robot.links.push_back(Link{.name = j < 5 ? std::string(names[j]) + "_frame" : "flange", .parent_joint = j});
  }
  return robot;
}

Rigid base_from_flange(const Eigen::VectorXd& p) { return {rotation_from_rpy(Vector3(p[5], p[4], p[3])), p.head<3>()}; }

Eigen::Matrix<double, 6, 1> make_position(const Rigid& pose) {
  const Vector3 rpy = rpy_from_rotation(pose.rotation);
  return (Eigen::Matrix<double, 6, 1>() << pose.translation, rpy.z(), rpy.y(), rpy.x()).finished();
}

namespace {

template <class Named>
int find_named(const std::vector<Named>& all, const std::string& name) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Named& one) { return one.name == name; });
  return found == all.end() ? -1 : static_cast<int>(found - all.begin());
}

}  // namespace

std::vector<std::string> link_names(const Robot& robot) {
  std::vector<std::string> names;
  for (const Link& link : robot.links) names.push_back(link.name);
  return names;
}

std::vector<std::string> joint_names(const Robot& robot) {
  std::vector<std::string> names;
  for (const Joint& joint : robot.joints)
    if (joint.moves() && !joint.is_mimic()) names.push_back(joint.name);
  return names;
}

int find_link(const Robot& robot, const std::string& name) { return find_named(robot.links, name); }

int find_joint(const Robot& robot, const std::string& name) { return find_named(robot.joints, name); }

std::vector<int> joints_to(const Robot& robot, int link) {
  std::vector<int> joints;
  for (int joint = robot.links[link].parent_joint; joint >= 0;
       joint = robot.links[robot.joints[joint].parent_link].parent_joint)
    joints.push_back(joint);
  std::reverse(joints.begin(), joints.end());
  return joints;
}

bool is_distal(const Robot& robot, int joint, int link) {
  for (int above = robot.links[link].parent_joint; above >= 0;
       above = robot.links[robot.joints[above].parent_link].parent_joint)
    if (above == joint) return true;
  return false;
}

}  // namespace handsight
