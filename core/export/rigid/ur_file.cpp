// SPDX-License-Identifier: Apache-2.0
#include "export/rigid/ur_file.h"

#include <array>

#include "base/files.h"
#include "base/numbers.h"
#include "base/text.h"

namespace handsight {
namespace {

struct UrJoint {
  const char *joint, *link;
};
constexpr std::array<UrJoint, 6> ur_joints{{{"shoulder_pan_joint", "shoulder"},
                                            {"shoulder_lift_joint", "upper_arm"},
                                            {"elbow_joint", "forearm"},
                                            {"wrist_1_joint", "wrist_1"},
                                            {"wrist_2_joint", "wrist_2"},
                                            {"wrist_3_joint", "wrist_3"}}};

int joint_that_ends_with(const Robot& robot, const std::string& name) {
  int found = -1;
  for (int j = 0; j < static_cast<int>(robot.joints.size()); ++j)
    if (robot.joints[static_cast<std::size_t>(j)].name.ends_with(name)) {
      if (found >= 0)
        throw InputError(
            message("The robot has two joints that end with {}: ur_calibration is of one arm; export its URDF.", name));
      found = j;
    }
  if (found < 0)
    throw InputError(message(
        "ur_calibration is for robots with UR's six joints, and this one has no joint {}; export as urdf or dh.",
        name));
  return found;
}

/// Where the joint is in the frame of the one before it, fixed joints between them included.
Rigid from_joint_before(const Robot& robot, int joint, int before) {
  Rigid motion = robot.joints[static_cast<std::size_t>(joint)].parent_from_joint;
  int link = robot.joints[static_cast<std::size_t>(joint)].parent_link;
  for (int j; (j = robot.links[static_cast<std::size_t>(link)].parent_joint) != before;) {
    if (j < 0 || robot.joints[static_cast<std::size_t>(j)].moves())
      throw InputError(message(
          "Joint {} does not follow the one before it in UR's order; ur_calibration is for UR's six joints one after "
          "another: export as urdf.",
          in_quotes(robot.joints[static_cast<std::size_t>(joint)].name)));
    motion = robot.joints[static_cast<std::size_t>(j)].parent_from_joint * motion;
    link = robot.joints[static_cast<std::size_t>(j)].parent_link;
  }
  return motion;
}

std::string block(const char* link, const Rigid& m) {
  const Vector3 rpy = rpy_from_rotation(m.rotation);
  const double numbers[] = {m.translation.x(), m.translation.y(), m.translation.z(), rpy.x(), rpy.y(), rpy.z()};
  const char* names[] = {"x", "y", "z", "roll", "pitch", "yaw"};
  std::string text = fmt::format("  {}:\n", link);
  for (int i = 0; i < 6; ++i) text += fmt::format("    {}: {}\n", names[i], format_number(numbers[i]));
  return text;
}

}  // namespace

std::string ur_file(const DescribedRobot& d) {
  std::string text;
  int before = -1;
  for (const UrJoint& ur : ur_joints) {
    const int j = joint_that_ends_with(d.robot, ur.joint);
    const Joint& joint = d.robot.joints[static_cast<std::size_t>(j)];
    if ((joint.axis - Vector3::UnitZ()).norm() > 1e-9)
      throw InputError(message(
          "Joint {} does not turn about its z axis: the robot is described otherwise than in ur_description, whose "
          "frames the file is read with; use its URDF, or export as urdf.",
          in_quotes(joint.name)));
    // The first stands in its parent link, base_link_inertia.
    text += block(ur.link, before < 0 ? joint.parent_from_joint : from_joint_before(d.robot, j, before));
    before = j;
  }
  const FileDigest digest = digest_of_content(text);
  std::string head = "# " + d.comment;
  for (std::size_t at = 0; (at = head.find('\n', at)) != std::string::npos; at += 3) head.replace(at, 1, "\n#");
  return head +
         "\n# For ur_description and the drivers (kinematics_params_file). The hash is of these numbers: the driver "
         "says "
         "that\n# it is not the robot's own calibration, which is true.\nkinematics:\n" +
         text + fmt::format("  hash: handsight_{:016x}\n", digest.first);
}

}  // namespace handsight
