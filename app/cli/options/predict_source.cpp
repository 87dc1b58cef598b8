// SPDX-License-Identifier: Apache-2.0
#include "predict_source.h"

#include "base/files.h"
#include "estimation/report/fit_report.h"
#include "printing/diagnosis_output.h"
#include "printing/outputs.h"
#include "robot/urdf.h"
#include "session/calibration_xml.h"
#include "session/session_xml.h"

namespace handsight::cli {
namespace {

CalibratedRobot from_session(const std::string& path, const std::string& robot_file,
                             const std::vector<std::string>& effects) {
  Session session = open_searched_session(path);
  std::filesystem::path urdf = folder(session) / session.robot_file;
  if (!robot_file.empty()) bind_robot(session, read_urdf(urdf = robot_file));
  FitOptions options;
  add_effects(effects, session, options.effects, options.estimated);
  const Fit fitted = fit(session, options);
  CalibratedRobot robot =
      calibrated_robot(session, fitted, report(session, fitted, options), options, "handsight " HANDSIGHT_VERSION);
  robot.urdf_text = read_file(urdf);
  robot.urdf_file = urdf.filename().string();
  return robot;
}

CalibratedRobot from_calibration(const std::string& path, const std::string& robot_file) {
  const Calibration c = read_calibration(path);
  if (robot_file.empty())
    throw InputError(fmt::format("{}: a calibration alone has no robot; name its URDF with --robot.", path));
  CalibratedRobot robot = calibrated_robot(c, read_urdf(robot_file), robot_file, path);
  robot.urdf_text = read_file(robot_file);
  robot.urdf_file = std::filesystem::path(robot_file).filename().string();
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
