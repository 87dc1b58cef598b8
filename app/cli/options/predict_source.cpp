// SPDX-License-Identifier: Apache-2.0
#include "predict_source.h"

#include "correct/robot_file.h"
#include "estimation/fit/part_fit.h"
#include "estimation/fit/touch_unknown.h"
#include "estimation/fit/undetermined.h"
#include "estimation/report/part_report.h"
#include "options/named_effects.h"
#include "printing/outputs.h"
#include "robot/urdf.h"
#include "session/calibration_xml.h"
#include "session/session_xml.h"

namespace handsight::cli {
namespace {

/// Which part of a collection is meant; where none is named, the first, if all have one hand and one mount.
int part_meant(const Session& joined, const std::string& title) {
  if (!title.empty() || joined.parts.empty()) return part_named(joined, title);
  const auto find_mount = [&](const SessionPart& p) -> const std::string& {
    return p.mount == 0 ? joined.mount.link : joined.other_mounts[static_cast<std::size_t>(p.mount - 1)].link;
  };
  if (joined.is_touch()) return 0;
  for (const SessionPart& p : joined.parts)
    if (p.tcp != joined.tcp || find_mount(p) != joined.mount.link)
      throw InputError(
          message("{}: its sessions have several hands or sensors; say which with --session, for example --session {}.",
                  joined.title, p.title));
  return 0;
}

/// One session of several, with the robot that all of them tell.
CalibratedRobot robot_of_part(const Session& joined, const Fit& fitted, const FitReport& reported,
                              const FitOptions& options, int part) {
  const PartFit own = fit_of_part(joined, fitted, part);
  const FitReport report_of_it = make_report(part_reports(joined, fitted, reported)[static_cast<std::size_t>(part)]);
  CalibratedRobot robot = calibrated_robot(own.session, own.fit, report_of_it, options, "handsight " HANDSIGHT_VERSION);
  if (joined.is_touch()) {  // by itself a fixture looks like a sensor that moves with the hand
    const auto of_it = static_cast<std::ptrdiff_t>(undetermined_texts(own.fit).size());
    robot.notes.erase(robot.notes.begin(), robot.notes.begin() + of_it);
    const std::vector<Message> of_all = touch_unknown_texts(joined, fitted);
    robot.notes.insert(robot.notes.begin(), of_all.begin(), of_all.end());
  }
  return robot;
}

CalibratedRobot from_session(const std::string& path, const std::string& robot_file,
                             const std::vector<std::string>& effects, const std::string& part) {
  Session session = open_searched_session(path);
  if (!part.empty()) part_named(session, part);
  const bool has_urdf = !session.robot.is_of_poses;
  if (!has_urdf && !robot_file.empty())
    throw InputError(
        message("--robot {}: the session has no joint angles for it, only where its flange is; leave the option out.",
                robot_file));
  const std::filesystem::path& file = session.parts.empty() ? session.file : session.parts.front().file;
  std::filesystem::path urdf = file.parent_path() / session.robot_file;
  if (!robot_file.empty()) bind_robot(session, read_urdf(urdf = robot_file));
  FitOptions options;
  add_effects(effects, session, options.effects, options.estimated);
  const Fit fitted = fit(session, options);
  const FitReport reported = report(session, fitted, options);
  CalibratedRobot robot = session.parts.empty()
                              ? calibrated_robot(session, fitted, reported, options, "handsight " HANDSIGHT_VERSION)
                              : robot_of_part(session, fitted, reported, options, part_meant(session, part));
  return has_urdf ? with_robot_file(std::move(robot), urdf) : robot;
}

/// That of the session that is named; where none is, the first, if all have one hand and one mount.
Calibration calibration_meant(const Calibration& all, const std::string& session, const std::string& path) {
  if (!session.empty()) return find_session(all, session);
  for (const Calibration& one : all.sessions)
    if (one.tcp != all.tcp || one.mount != all.mount)
      throw InputError(
          message("{}: it holds several hands or sensors; say which with --session, for example --session {}.", path,
                  one.session));
  return all;
}

CalibratedRobot from_calibration(const std::string& path, const std::string& robot_file, const std::string& session) {
  const Calibration c = calibration_meant(read_calibration(path), session, path);
  if (c.joints == joint_names(poses_robot())) return calibrated_robot(c, poses_robot(), "", path);
  if (robot_file.empty())
    throw InputError(message("{}: a calibration alone has no robot; name its URDF with --robot.", path));
  return with_robot_file(calibrated_robot(c, read_urdf(robot_file), robot_file, path), robot_file);
}

}  // namespace

CalibratedRobot predict_source(const std::string& source, const std::string& robot_file,
                               const std::vector<std::string>& effects, const std::string& session) {
  if (!is_calibration_file(source)) return from_session(source, robot_file, effects, session);
  if (!effects.empty())
    throw InputError(message(
        "{}: a calibration holds its effects already; --effects is for sessions, which are fitted here.", source));
  return from_calibration(source, robot_file, session);
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
  command.option("--session", options.session, "Of a collection, or its calibration: the session whose hand is meant");
  command.option("--effects", options.effects,
                 "Effects in a session's model: id or id:joint+joint to estimate, id:joint.parameter=value to hold");
}

CalibratedRobot predict_source(const SourceOptions& options) {
  for (const std::string& input : {options.source, options.robot}) note_input(input);
  return predict_source(options.source, options.robot, options.effects, options.session);
}

}  // namespace handsight::cli
