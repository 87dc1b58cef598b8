// SPDX-License-Identifier: Apache-2.0
#include "export/rigid/dh_file.h"

#include "base/numbers.h"
#include "base/text.h"
#include "export/number_files.h"
#include "export/rigid/dh.h"

namespace handsight {
namespace {

std::string number(double x) { return format_number(x == 0 ? 0.0 : x); }  // no -0

const Joint& joint_of(const DescribedRobot& d, const DhRow& row) {
  return d.robot.joints[static_cast<std::size_t>(row.joint)];
}

bool slides(const DescribedRobot& d, const DhRow& row) { return joint_of(d, row).kind == JointKind::prismatic; }

std::string head(const DescribedRobot& d) {
  std::string text = "# " + d.comment;
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 3) text.replace(at, 1, "\n#");
  return text +
         "\n# root_from_hand = base * T(row 1) * ... * T(row n) * tool; lengths in m, angles in rad.\n"
         "# modified (Craig): T = Rx(alpha) Tx(a) Rz(theta + q) Tz(d); classical: T = Rz(theta + q) Tz(d) Tx(a) "
         "Rx(alpha).\n# A prismatic joint adds q to d, not to theta.\n";
}

std::string csv_motion(const char* convention, const char* what, const Rigid& m) {
  const Vector3 rpy = rpy_from_rotation(m.rotation);
  return fmt::format("{},{},,,,,,{},{},{},{},{},{}\n", convention, what, number(m.translation.x()),
                     number(m.translation.y()), number(m.translation.z()), number(rpy.x()), number(rpy.y()),
                     number(rpy.z()));
}

std::string csv_table(const DescribedRobot& d, const char* convention, const DhChain& chain) {
  std::string text = csv_motion(convention, "base", chain.base);
  for (const DhRow& row : chain.rows)
    text += fmt::format("{},{},{},{},{},{},{},,,,,,\n", convention, field_of_table(joint_of(d, row).name),
                        slides(d, row) ? "prismatic" : "revolute", number(row.a), number(row.alpha), number(row.d),
                        number(row.theta));
  return text + csv_motion(convention, "tool", chain.tool);
}

std::string yaml_motion(const char* what, const Rigid& m) {
  const Vector3 rpy = rpy_from_rotation(m.rotation);
  const Matrix4 by_rows = matrix_from_rigid(m).transpose();
  std::string matrix;
  for (const double x : by_rows.reshaped()) matrix += (matrix.empty() ? "" : ", ") + number(x);
  return fmt::format("  {}: {{xyz: [{}, {}, {}], rpy: [{}, {}, {}], matrix: [{}]}}\n", what, number(m.translation.x()),
                     number(m.translation.y()), number(m.translation.z()), number(rpy.x()), number(rpy.y()),
                     number(rpy.z()), matrix);
}

std::string yaml_table(const DescribedRobot& d, const char* convention, const DhChain& chain) {
  std::string text = fmt::format("{}:\n{}  joints:\n", convention, yaml_motion("base", chain.base));
  for (const DhRow& row : chain.rows)
    text += fmt::format("    - {{name: {}, type: {}, a: {}, alpha: {}, d: {}, theta: {}}}\n",
                        quoted_text(joint_of(d, row).name), slides(d, row) ? "prismatic" : "revolute", number(row.a),
                        number(row.alpha), number(row.d), number(row.theta));
  return text + yaml_motion("tool", chain.tool);
}

}  // namespace

std::string dh_file(const DescribedRobot& d, TableForm form) {
  const int hand = find_link(d.robot, d.urdf.hand_link);
  const DhChain modified = modified_dh(d.robot, hand), classical = classical_dh(d.robot, hand);
  if (modified.rows.empty())
    throw InputError(
        message("No joint moves the hand {}: there are no Denavit-Hartenberg parameters to write; name "
                "the link that the robot moves as tcp.",
                in_quotes(d.urdf.hand_link)));
  if (form == TableForm::yaml)
    return head(d) + yaml_table(d, "modified", modified) + yaml_table(d, "classical", classical);
  return head(d) + "convention,joint,type,a,alpha,d,theta,x,y,z,roll,pitch,yaw\n" + csv_table(d, "modified", modified) +
         csv_table(d, "classical", classical);
}

}  // namespace handsight
