// SPDX-License-Identifier: Apache-2.0
#include "ways/flange_robot.h"

#include <fmt/format.h>

namespace handsight {
namespace {

struct Part {
  const char *name, *type, *axis;
};
constexpr Part parts[] = {{"flange_x", "prismatic", "1 0 0"},      {"flange_y", "prismatic", "0 1 0"},
                          {"flange_z", "prismatic", "0 0 1"},      {"flange_yaw", "continuous", "0 0 1"},
                          {"flange_pitch", "continuous", "0 1 0"}, {"flange_roll", "continuous", "1 0 0"}};

}  // namespace

std::string flange_robot_urdf() {
  std::string text =
      "<robot name=\"flange_poses\">\n"
      "  <!-- No robot: its joints are the pose of a flange, three slides and three turns. What is found of them says "
      "nothing of the joints of the robot that carried it. -->\n"
      "  <link name=\"base\"/>\n";
  std::string parent = "base";
  for (const Part& part : parts) {
    const std::string child = std::string(part.name) == "flange_roll" ? "flange" : std::string(part.name) + "_link";
    const char* const limit = std::string(part.type) == "prismatic"
                                  ? "<limit lower=\"-100\" upper=\"100\" effort=\"0\" velocity=\"0\"/>"
                                  : "";
    text += fmt::format(
        "  <link name=\"{0}\"/>\n  <joint name=\"{1}\" type=\"{2}\"><parent link=\"{3}\"/><child link=\"{0}\"/><axis "
        "xyz=\"{4}\"/>{5}</joint>\n",
        child, part.name, part.type, parent, part.axis, limit);
    parent = child;
  }
  return text + "</robot>\n";
}

JointSeries flange_joints(const PoseSeries& base_from_flange) {
  JointSeries series;
  for (const Part& part : parts) series.names.emplace_back(part.name);
  series.times = base_from_flange.times;
  for (const Rigid& pose : base_from_flange.poses) {
    const Vector3 rpy = rpy_from_rotation(pose.rotation);
    Eigen::VectorXd q(6);
    q << pose.translation, rpy.z(), rpy.y(), rpy.x();
    series.positions.push_back(q);
  }
  return series;
}

}  // namespace handsight
