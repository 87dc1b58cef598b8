// SPDX-License-Identifier: Apache-2.0
#include "predict_source.h"

#include "base/files.h"
#include "estimation/report/fit_report.h"
#include "options/named_effects.h"
#include "printing/outputs.h"
#include "robot/urdf.h"
#include "session/calibration_xml.h"
#include "session/session_xml.h"

namespace handsight::cli {
namespace {

CalibratedRobot from_session(const std::string& path, const std::string& robot_file,
                             const std::vector<std::string>& effects) {
  Session session = open_searched_session(path);
  const bool has_urdf = !session.robot.is_of_poses;
  if (!has_urdf && !robot_file.empty())
    throw InputError(fmt::format(
        "--robot {}: the session has no joint angles for it, only where its flange is; leave the option out.",
        robot_file));
  std::filesystem::path urdf = folder(session) / session.robot_file;
  if (!robot_file.empty()) bind_robot(session, read_urdf(urdf = robot_file));
  FitOptions options;
  add_effects(effects, session, options.effects, options.estimated);
  const Fit fitted = fit(session, options);
  CalibratedRobot robot =
      calibrated_robot(session, fitted, report(session, fitted, options), options, "handsight " HANDSIGHT_VERSION);
  if (!has_urdf) return robot;
  robot.urdf_text = read_file(urdf);
  robot.urdf_file = urdf.filename().string();
  robot.robot_folder = std::filesystem::absolute(urdf).parent_path();
  return robot;
}

CalibratedRobot from_calibration(const std::string& path, const std::string& robot_file) {
  const Calibration c = read_calibration(path);
  if (c.joints == joint_names(poses_robot())) return calibrated_robot(c, poses_robot(), "", path);
  if (robot_file.empty())
    throw InputError(fmt::format("{}: a calibration alone has no robot; name its URDF with --robot.", path));
  CalibratedRobot robot = calibrated_robot(c, read_urdf(robot_file), robot_file, path);
  robot.urdf_text = read_file(robot_file);
  robot.urdf_file = std::filesystem::path(robot_file).filename().string();
  robot.robot_folder = std::filesystem::absolute(robot_file).parent_path();
  return robot;
}

}  // namespace

CalibratedRobot predict_source(const std::string& source, const std::string& robot_file,
                               const std::vector<std::string>& effects) {
  if (!is_calibration_file(source)) return from_session(source, robot_file, effects);
  if (!effects.empty())
    throw InputError(fmt::format(
        "{}: a calibration holds its effects already; --effects is for sessions, which are fitted here.", source));
  return from_calibration(source, robot_file);
}

void require_joints(const CalibratedRobot& robot) {
  if (robot.chain.robot.is_of_poses)
    throw InputError(
        "There are no joints, only poses of the flange, which are taken as they are told: nothing of the robot is left "
        "to correct. What was found is where the sensor and the target sit: see fit, predict for a pose of the flange, "
        "and export --as static_tf, yaml, opencv or csv.");
}

void add_source_options(const CommandLine& command, SourceOptions& options) {
  command.option("SESSION", options.source, "A session, or a calibration XML").required();
  command.option("--robot", options.robot, "URDF; needed with a calibration");
  command.option("--effects", options.effects,
                 "Effects in a session's model: id or id:joint+joint to estimate, id:joint.parameter=value to hold");
}

CalibratedRobot predict_source(const SourceOptions& options) {
  for (const std::string& input : {options.source, options.robot}) note_input(input);
  return predict_source(options.source, options.robot, options.effects);
}

}  // namespace handsight::cli
