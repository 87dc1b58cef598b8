// SPDX-License-Identifier: Apache-2.0
#include "predict_source.h"

#include "base/files.h"
#include "command.h"
#include "robot/urdf.h"
#include "session/calibration_xml.h"

namespace handsight::cli {
namespace {

bool is_calibration(const std::string& path) {
  return !std::filesystem::is_directory(path) && read_file(path).find("<handsight_calibration") != std::string::npos;
}

PredictSource from_session(const std::string& path, const std::string& robot_file) {
  Session session = open_session(path);
  if (!robot_file.empty()) session.robot = read_urdf(robot_file);
  const Fit fitted = fit(session);
  PredictSource source;
  source.chain = chain_of(session);
  source.joint_names = session.joints;
  source.model = prediction_model(fitted);
  source.times = times_of(session);
  if (source.model.scatter.observations < 3)
    source.notes.push_back(
        "Fewer than three observations show three markers: how the real TCP scatters about the model is not known, and "
        "sigma leaves it out.");
  return source;
}

PredictSource from_calibration(const std::string& path, const std::string& robot_file) {
  const Calibration c = read_calibration(path);
  if (robot_file.empty())
    throw InputError(fmt::format("{}: a calibration alone has no robot; name its URDF with --robot.", path));
  if (c.tcp.empty() || c.joints.empty())
    throw InputError(fmt::format(
        "{}: has no <robot> with the tcp link or no <joints> with their order; predict from its session.", path));
  Session session;
  session.file = path;
  session.robot_file = robot_file;
  session.robot = read_urdf(robot_file);
  session.tcp = c.tcp;
  session.mount.link = c.mount;
  session.gravity = c.gravity.value_or(session.gravity);
  session.joints = c.joints;
  PredictSource source;
  source.joint_names = c.joints;
  source.model = prediction_model(c, session.robot);
  session.marker_count = std::max(static_cast<int>(c.markers.size()), markers_of(source.model.effects));
  source.chain = chain_of(session);
  source.times = c.times;
  source.notes = c.notes;
  if (!c.effects.empty() && !c.model_covariance)
    source.notes.push_back(
        "The file does not say how the errors of TCP->Body and of the effects go together (<model_covariance>): sigma "
        "takes them as independent and is too large.");
  return source;
}

}  // namespace

PredictSource predict_source(const std::string& session_or_calibration, const std::string& robot_file) {
  if (!is_calibration(session_or_calibration)) return from_session(session_or_calibration, robot_file);
  return from_calibration(session_or_calibration, robot_file);
}

}  // namespace handsight::cli
