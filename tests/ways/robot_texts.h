// SPDX-License-Identifier: Apache-2.0
// URDF texts of robots that tests make in code.
#pragma once

#include <fmt/format.h>

#include "robot/robot.h"

namespace handsight::fixture {

inline std::string urdf_text(const Robot& robot) {
  const auto three = [](const Vector3& v) { return fmt::format("{} {} {}", v.x(), v.y(), v.z()); };
  const auto origin = [&](const Rigid& m) {
    return fmt::format("<origin xyz=\"{}\" rpy=\"{}\"/>", three(m.translation), three(rpy_from_rotation(m.rotation)));
  };
  std::string text = "<robot name=\"" + robot.name + "\">\n";
  for (const Link& l : robot.links)
    text += fmt::format(
        "<link name=\"{}\"><inertial><mass value=\"{}\"/>{}</inertial><visual>{}<geometry><box size=\"0.1 0.1 "
        "0.1\"/></geometry></visual></link>\n",
        l.name, l.mass, origin({Matrix3::Identity(), l.center_of_mass}), origin({Matrix3::Identity(), {0.01, 0, 0}}));
  for (const Joint& j : robot.joints) {
    const char* const kind = j.kind == JointKind::fixed       ? "fixed"
                             : j.kind == JointKind::prismatic ? "prismatic"
                                                              : "revolute";
    text += fmt::format(
        "<joint name=\"{}\" type=\"{}\"><parent link=\"{}\"/><child link=\"{}\"/>{}<axis xyz=\"{}\"/>"
        "<limit lower=\"{}\" upper=\"{}\" effort=\"1\" velocity=\"1\"/>",
        j.name, kind, robot.links[static_cast<std::size_t>(j.parent_link)].name,
        robot.links[static_cast<std::size_t>(j.child_link)].name, origin(j.parent_from_joint), three(j.axis), j.lower,
        j.upper);
    for (const Mimic& m : j.mimics)
      text += fmt::format("<mimic joint=\"{}\" multiplier=\"{}\" offset=\"{}\"/>",
                          robot.joints[static_cast<std::size_t>(m.joint)].name, m.multiplier, m.offset);
    text += "</joint>\n";
  }
  return text + "</robot>\n";
}

}  // namespace handsight::fixture
