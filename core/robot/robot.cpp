// SPDX-License-Identifier: Apache-2.0
#include "robot/robot.h"

#include <algorithm>

namespace handsight {

namespace {

template <class Named>
int find_named(const std::vector<Named>& all, const std::string& name) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Named& one) { return one.name == name; });
  return found == all.end() ? -1 : static_cast<int>(found - all.begin());
}

}  // namespace

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
