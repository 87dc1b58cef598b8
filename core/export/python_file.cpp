// SPDX-License-Identifier: Apache-2.0
#include "export/python_file.h"

#include "base/error.h"
#include "base/numbers.h"
#include "base/text.h"
#include "export/cpp_file.h"
#include "export/python_engine.h"
#include "robot/posture.h"

namespace handsight {
namespace {

std::string python_number(double x) { return format_number(x); }

std::string python_list(const Vector3& v) {
  return fmt::format("[{}, {}, {}]", python_number(v.x()), python_number(v.y()), python_number(v.z()));
}

std::string python_list(const Rigid& m) {
  const auto row = [&](int i) { return python_list(Vector3(m.rotation.row(i).transpose())); };
  return fmt::format("([{}, {}, {}], {})", row(0), row(1), row(2), python_list(m.translation));
}

std::string python_text(const std::string& name) {
  std::string text;
  for (const char c : shortened(name, 500)) text += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  return "\"" + text + "\"";
}

std::string joint_row(const ProgramJoint& joint) {
  std::string mimics;
  for (const Mimic& m : joint.mimics)
    mimics += fmt::format("({}, {}, {}),", m.joint, python_number(m.multiplier), python_number(m.offset));
  const char* const kind = joint.kind == JointKind::fixed ? "f" : joint.kind == JointKind::prismatic ? "s" : "t";
  return fmt::format(
      "    # {}\n    _Joint({}, \"{}\", {}, {},\n           {}, {},\n           {}, {}, {}, {}, {}, [{}]),\n",
      printable(shortened(joint.name, 100)), joint.parent, kind, joint.input, python_list(joint.parent_from_joint),
      python_list(joint.axis), python_list(joint.joint_from_child), python_number(joint.stiffness),
      python_number(joint.mass), python_list(joint.moment), python_number(joint.lower), python_number(joint.upper),
      mimics);
}

std::string python_tables(const HandProgram& p) {
  std::string names, rows, order;
  for (const std::string& name : p.inputs) names += (names.empty() ? "" : ", ") + python_text(name);
  for (const ProgramJoint& joint : p.joints) rows += joint_row(joint);
  for (const int j : p.value_order) order += (order.empty() ? "" : ", ") + std::to_string(j);
  const auto truth = [](bool b) { return b ? "True" : "False"; };
  return fmt::format(
      "\nJOINT_NAMES = [{}]  # the order of a position\n\n_JOINTS = [\n{}]\n_VALUE_ORDER = [{}]\n_TCP_JOINT = "
      "{}\n_CHILD_FROM_TCP = {}\n_CENTER_IN_TCP = {}\n_TCP_FROM_BODY = {}\n_GRAVITY = {}\n_ROOT_MOMENT = "
      "{}\n_MOUNT_JOINT = {}\n_CHILD_FROM_MOUNT = {}\n_NOMINAL_IS_ELASTIC, _IS_ELASTIC, _READS_TORQUE, _READS_PLACE = "
      "{}, "
      "{}, {}, {}\n",
      names, rows, order, p.tcp, python_list(p.child_from_tcp), python_list(p.center_in_tcp),
      python_list(p.tcp_from_body), python_list(p.gravity), python_list(p.root_moment), p.mount,
      python_list(p.child_from_mount), truth(p.nominal_is_elastic), truth(p.is_elastic), truth(p.reads_torque),
      truth(p.reads_place));
}

std::string python_effects(const HandProgram& p) {
  std::string text =
      "\n\ndef _add_effects(q, torque, tcp, velocity, approach, share, seconds, order, joint, whole):\n"
      "    \"\"\"What the effects add, each as it was found.\"\"\"\n";
  std::string of;
  for (const ProgramMove& m : p.moves) {
    if (m.of != of) text += "    # " + printable(shortened(of = m.of, 200)) + "\n";
    text += "    " + m.target + " += " + python_text(m.amount) + "\n";
  }
  return text;
}

}  // namespace

std::string python_file(const HandProgram& p) {
  return "#!/usr/bin/env python3\n" + program_comment(p, "#") + python_types + python_tables(p) + python_effects(p) +
         python_engine + python_correction;
}

}  // namespace handsight
