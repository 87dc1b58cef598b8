// SPDX-License-Identifier: Apache-2.0
#include "export/exported.h"

#include <algorithm>

#include "base/error.h"
#include "base/text.h"
#include "export/cpp_file.h"
#include "export/number_files.h"
#include "export/python_file.h"
#include "export/urdf_file.h"

namespace handsight {
namespace {

ExportedFile program_file(const CalibratedRobot& robot, bool is_python) {
  const HandProgram program = hand_program(robot);
  return {is_python ? python_file(program) : cpp_file(program), program.left_out};
}

ExportedFile urdf(const CalibratedRobot& robot) {
  UrdfFile file = urdf_file(robot);
  ExportedFile out{std::move(file.text), {}};
  for (const std::string& what : file.not_said)
    out.notes.push_back("A URDF cannot say " + shortened(what, 400) + "; it is named in the file's comment.");
  if (file.sensor_link.empty())
    out.notes.emplace_back("The calibration does not say where the sensor sits; the file has no link for it.");
  return out;
}

/// What is the same in all poses, and nothing more.
void note_effects(const CalibratedRobot& robot, ExportedFile& file) {
  if (!robot.model.effects.empty())
    file.notes.push_back(
        fmt::format("This kind of file holds fixed transforms alone: the {} effects of the model that move the arm are "
                    "not in it; export as cpp or python for the whole hand pose.",
                    robot.model.effects.size()));
}

}  // namespace

ExportedFile exported_file(const CalibratedRobot& robot, const std::string& kind) {
  const bool needs_joints = kind == "urdf" || kind == "cpp" || kind == "python";
  if (needs_joints && robot.chain.robot.is_of_poses)
    throw InputError(fmt::format(
        "A file of kind {} is of a robot with joints, and only the poses of the flange are known here; export where "
        "sensor and target sit as static_tf, yaml, opencv or csv.",
        kind));
  if (kind == "urdf") return urdf(robot);
  if (kind == "yaml") return {yaml_file(robot), {}};
  if (kind == "csv") return {csv_file(robot), {}};
  if (kind == "cpp" || kind == "python") return program_file(robot, kind == "python");
  ExportedFile file;
  if (kind == "opencv") file.text = opencv_file(robot);
  if (kind == "static_tf") file.text = static_tf_file(robot);
  if (file.text.empty())
    throw InputError(
        fmt::format("{} is no kind of export; expected one of: {}.", in_quotes(kind), fmt::join(export_kinds, " ")));
  note_effects(robot, file);
  return file;
}

}  // namespace handsight
