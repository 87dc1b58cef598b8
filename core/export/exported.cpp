// SPDX-License-Identifier: Apache-2.0
#include "export/exported.h"

#include <algorithm>

#include "base/error.h"
#include "base/text.h"
#include "export/cpp_file.h"
#include "export/hand_program.h"
#include "export/number_files.h"
#include "export/python_file.h"
#include "export/reported_motion.h"
#include "export/rigid/dh_file.h"
#include "export/rigid/mjcf_file.h"
#include "export/rigid/offset_files.h"
#include "export/rigid/sdf_file.h"
#include "export/rigid/ur_file.h"
#include "export/rigid/xacro_file.h"

namespace handsight {
namespace {

void set_left(ExportedFile& file, const RigidFit& fit) {
  file.left = fit.left.rms;
  file.largest_left = fit.left.largest;
  file.nominal = fit.nominal.rms;
  file.poses = fit.poses;
}

/// Nothing is left out: the program is the calibration.
ExportedFile program_file(const CalibratedRobot& robot, bool is_python) {
  const HandProgram program = hand_program(robot);
  ExportedFile file{is_python ? python_file(program) : cpp_file(program), {}};
  for (const std::string& left : program.left_out) file.notes.push_back(looked_up(left));
  file.left = file.largest_left = 0;
  file.nominal = missed_with(robot, {}).rms;
  file.poses = static_cast<int>(robot.positions.size());
  return file;
}

void note_left(const RigidFit& fit, ExportedFile& file) {
  set_left(file, fit);
  if (const Message left = left_sentence(fit); !left.empty()) file.notes.push_back(left);
}

ExportedFile urdf(const CalibratedRobot& robot, const ExportOptions&) {
  UrdfFile made = urdf_file(robot);
  ExportedFile file{std::move(made.text), {}};
  for (const Message& what : made.not_said)
    file.notes.push_back(message("A URDF cannot say {}; it is named in the file's comment.", at_most(what, 400)));
  note_left(made.fit, file);
  if (made.sensor_link.empty())
    file.notes.emplace_back("The calibration does not say where the sensor sits; the file has no link for it.");
  return file;
}

ExportedFile xacro(const CalibratedRobot& robot, const ExportOptions&) {
  const DescribedRobot d = described_robot(robot);
  ExportedFile file{xacro_file(d), {}};
  note_left(d.urdf.fit, file);
  return file;
}

ExportedFile mjcf(const CalibratedRobot& robot, const ExportOptions& options) {
  const DescribedRobot d = described_robot(robot);
  ExportedFile file;
  file.text = mjcf_file(d, robot.chain.gravity, options.file.parent_path(), file.notes);
  note_left(d.urdf.fit, file);
  return file;
}

ExportedFile sdf(const CalibratedRobot& robot, const ExportOptions& options) {
  const DescribedRobot d = described_robot(robot);
  ExportedFile file;
  file.text = sdf_file(d, options.file.parent_path(), file.notes);
  note_left(d.urdf.fit, file);
  return file;
}

ExportedFile dh(const CalibratedRobot& robot, const ExportOptions& options) {
  const DescribedRobot d = described_robot(robot);
  const bool is_table = options.file.extension() == ".csv";
  ExportedFile file{dh_file(d, is_table ? TableForm::csv : TableForm::yaml), {}};
  note_left(d.urdf.fit, file);
  return file;
}

ExportedFile ur_calibration(const CalibratedRobot& robot, const ExportOptions&) {
  const DescribedRobot d = described_robot(robot, Holds::moving_origins);
  ExportedFile file{ur_file(d), {}};
  note_left(d.urdf.fit, file);
  return file;
}

ExportedFile ros2_control(const CalibratedRobot& robot, const ExportOptions&) {
  const RigidFit fit = rigid_fit(robot, Holds::offsets);
  ExportedFile file{ros2_control_file(robot, fit), {}};
  note_left(fit, file);
  return file;
}

ExportedFile lerobot(const CalibratedRobot& robot, const ExportOptions& options) {
  RigidFit fit = rigid_fit(robot, Holds::offsets);
  ExportedFile file{lerobot_file(robot, fit, options.lerobot), {}};
  note_left(fit, file);
  if (options.lerobot.empty())
    file.notes.emplace_back(
        "homing_offset is what is to be added to that of your arm, and the other numbers are those of a motor that "
        "reads a whole turn; name the arm's own calibration with --lerobot to have it changed.");
  file.notes.emplace_back(
      "The signs are those of Feetech's motors (SO-100, SO-101); Dynamixel's add homing_offset where these subtract "
      "it.");
  return file;
}

/// What is the same in all poses, and nothing more.
void note_effects(const CalibratedRobot& robot, ExportedFile& file) {
  if (!robot.model.effects.empty())
    file.notes.push_back(
        message("This kind of file holds fixed transforms alone: the {} effects of the model that move the arm are "
                "not in it; export as cpp or python for the whole hand pose.",
                robot.model.effects.size()));
}

ExportedFile opencv(const CalibratedRobot& robot, const ExportOptions&) {
  ExportedFile file{opencv_file(robot), undetermined_texts(robot, nan_instead)};
  note_effects(robot, file);
  return file;
}

ExportedFile static_tf(const CalibratedRobot& robot, const ExportOptions&) {
  ExportedFile file{static_tf_file(robot), undetermined_texts(robot, left_out_instead)};
  note_effects(robot, file);
  return file;
}

ExportedFile cpp(const CalibratedRobot& robot, const ExportOptions&) { return program_file(robot, false); }
ExportedFile python(const CalibratedRobot& robot, const ExportOptions&) { return program_file(robot, true); }
ExportedFile yaml(const CalibratedRobot& robot, const ExportOptions&) {
  return {yaml_file(robot), undetermined_texts(robot, nan_instead)};
}
ExportedFile csv(const CalibratedRobot& robot, const ExportOptions&) {
  return {csv_file(robot), undetermined_texts(robot, nan_instead)};
}

struct Maker {
  const char* id;
  bool needs_joints;
  ExportKind reported;
  ExportedFile (*make)(const CalibratedRobot&, const ExportOptions&);
};

constexpr std::array<Maker, export_kinds.size()> makers{{
    {"urdf", true, {".urdf", "URDF"}, urdf},
    {"xacro", true, {".xacro", "xacro"}, xacro},
    {"mjcf", true, {".mjcf.xml", "MuJoCo (MJCF)"}, mjcf},
    {"sdf", true, {".sdf", "SDFormat (Gazebo)"}, sdf},
    {"dh", true, {".dh.yaml", "Denavit-Hartenberg"}, dh},
    {"ur_calibration", true, {".ur.yaml", "UR (ur_description)"}, ur_calibration},
    {"yaml", false, {".yaml", "YAML"}, yaml},
    {"csv", false, {".csv", "CSV"}, csv},
    {"opencv", false, {".opencv.yaml", "OpenCV"}, opencv},
    {"lerobot", true, {".lerobot.json", "lerobot"}, lerobot},
    {"ros2_control", true, {".ros2_control.xml", "ros2_control"}, ros2_control},
    {"static_tf", false, {".launch.py", "ROS 2 static_tf"}, static_tf},
    {"cpp", true, {".cpp", "C++"}, cpp},
    {"python", true, {".py", "Python"}, python},
}};

const Maker& maker_of(const std::string& kind) {
  const auto found = std::find_if(makers.begin(), makers.end(), [&](const Maker& m) { return kind == m.id; });
  if (found == makers.end())
    throw InputError(
        message("{} is no kind of export; expected one of: {}.", in_quotes(kind), fmt::join(export_kinds, " ")));
  return *found;
}

}  // namespace

ExportKind export_kind(const std::string& kind) { return maker_of(kind).reported; }

ExportedFile exported_file(const CalibratedRobot& robot, const std::string& kind, const ExportOptions& options) {
  const Maker& maker = maker_of(kind);
  if (maker.needs_joints && robot.chain.robot.is_of_poses)
    throw InputError(message(
        "A file of kind {} is of a robot with joints, and only the poses of the flange are known here; export where "
        "sensor and target sit as static_tf, yaml, opencv or csv.",
        kind));
  return maker.make(robot, options);
}

}  // namespace handsight
