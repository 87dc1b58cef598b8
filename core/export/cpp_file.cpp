// SPDX-License-Identifier: Apache-2.0
#include "export/cpp_file.h"

#include "base/error.h"
#include "base/numbers.h"
#include "base/text.h"
#include "export/cpp_engine.h"
#include "robot/posture.h"

namespace handsight {
namespace {

std::string listed(const double* numbers, std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += (i ? ", " : "") + format_number(numbers[i]);
  return "{" + text + "}";
}

std::string listed(const Vector3& v) { return listed(v.data(), 3); }

std::string listed(const Rigid& m) {
  const Matrix3 columns = m.rotation.transpose();  // Eigen's columns are the rows that are written
  return fmt::format("{{{{{}, {}, {}}}, {}}}", listed(Vector3(columns.col(0))), listed(Vector3(columns.col(1))),
                     listed(Vector3(columns.col(2))), listed(m.translation));
}

std::string quoted(const std::string& name) {
  std::string text;
  for (const char c : shortened(name, 500)) text += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  return "\"" + text + "\"";
}

char kind_of(JointKind kind) { return kind == JointKind::fixed ? 'f' : kind == JointKind::prismatic ? 's' : 't'; }

std::string joint_rows(const HandProgram& p) {
  std::string text;
  std::size_t mimics = 0;
  for (std::size_t j = 0; j < p.joints.size(); ++j) {
    const ProgramJoint& joint = p.joints[j];
    text += fmt::format("    // {} {}\n    {{{}, '{}', {}, {},\n     {}, {},\n     {}, {}, {}, {}, {}, {}, {}}},\n", j,
                        printable(shortened(joint.name, 100)), joint.parent, kind_of(joint.kind), joint.input,
                        listed(joint.parent_from_joint), listed(joint.axis), listed(joint.joint_from_child),
                        format_number(joint.stiffness), format_number(joint.mass), listed(joint.moment),
                        format_number(joint.lower), format_number(joint.upper), mimics, joint.mimics.size());
    mimics += joint.mimics.size();
  }
  return text;
}

std::string mimic_rows(const HandProgram& p) {
  std::string text;
  for (const ProgramJoint& joint : p.joints)
    for (const Mimic& m : joint.mimics)
      text += fmt::format("    {{{}, {}, {}}},\n", m.joint, format_number(m.multiplier), format_number(m.offset));
  return text.empty() ? "    {0, 0, 0},  // no joint follows another\n" : text;
}

std::string tables(const HandProgram& p) {
  std::string order;
  for (const int j : p.value_order) order += (order.empty() ? "" : ", ") + std::to_string(j);
  const auto truth = [](bool b) { return b ? "true" : "false"; };
  return fmt::format(
      "\nconstexpr int count = {};\nconstexpr int tcp_joint = {}, mount_joint = {};\nconstexpr bool nominal_is_elastic "
      "= {}, is_elastic = {}, reads_torque = {}, reads_place = {};\nconstexpr int value_order[count] = {{{}}};\n"
      "const double gravity[3] = {}, root_moment[3] = {}, center_in_tcp[3] = {};\n"
      "const Motion child_from_tcp = {};\nconst Motion child_from_mount = {};\nconst Motion tcp_from_body = {};\n\n"
      "const Joint joints[count] = {{\n{}}};\n\nconst Mimic mimics[] = {{\n{}}};\n",
      p.joints.size(), p.tcp, p.mount, truth(p.nominal_is_elastic), truth(p.is_elastic), truth(p.reads_torque),
      truth(p.reads_place), order, listed(p.gravity), listed(p.root_moment), listed(p.center_in_tcp),
      listed(p.child_from_tcp), listed(p.child_from_mount), listed(p.tcp_from_body), joint_rows(p), mimic_rows(p));
}

std::string effects(const HandProgram& p) {
  std::string text =
      "\n/// What the effects add, each as it was found.\ninline void add_effects([[maybe_unused]] const double* q, "
      "[[maybe_unused]] const double* torque,\n                        [[maybe_unused]] const double* tcp, "
      "[[maybe_unused]] const double* velocity, "
      "[[maybe_unused]] const double* approach,\n                        [[maybe_unused]] double share, "
      "[[maybe_unused]] double seconds, [[maybe_unused]] double order,\n                        [[maybe_unused]] "
      "JointChange* joint, [[maybe_unused]] WholeChange& whole) {\n";
  std::string of;
  for (const ProgramMove& m : p.moves) {
    if (m.of != of) text += "  // " + printable(shortened(of = m.of, 200)) + "\n";
    text += "  " + m.target + " += " + cpp_text(m.amount) + ";\n";
  }
  return text + "}\n";
}

std::string names(const HandProgram& p) {
  std::string text;
  for (const std::string& name : p.inputs) text += (text.empty() ? "" : ", ") + quoted(name);
  return fmt::format(
      "namespace handsight_hand {{\n\n/// The order of a position: rad, m where a joint slides.\nconstexpr int "
      "joint_count = {};\nconst char* const joint_names[joint_count] = {{{}}};\n",
      p.inputs.size(), text);
}

}  // namespace

std::string program_comment(const HandProgram& p, const std::string& mark) {
  std::string text = fmt::format(
      "{0} Where the hand really is: the robot's calibrated model, with every effect that was found in it.\n{0} Made "
      "by "
      "Handsight from {1}{2}. Units: m, rad, s, kg, N.\n",
      mark, in_quotes(p.title, 200), p.created.empty() ? "" : ", calibrated " + shortened(p.created));
  for (const std::string& sentence : p.left_out) text += mark + " " + printable(shortened(sentence, 300)) + "\n";
  return text;
}

std::string cpp_file(const HandProgram& p) {
  return program_comment(p, "//") +
         "#ifndef HANDSIGHT_HAND_H\n#define HANDSIGHT_HAND_H\n\n#include <algorithm>\n#include <cmath>\n\n" + names(p) +
         cpp_types + tables(p) + effects(p) + cpp_engine + cpp_correction + cpp_interface + "\n#endif\n";
}

}  // namespace handsight
