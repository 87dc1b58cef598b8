// SPDX-License-Identifier: Apache-2.0
#include "correct/calibrated_robot.h"

#include <algorithm>

#include "base/files.h"
#include "base/text.h"
#include "estimation/fit/touch_unknown.h"
#include "estimation/report/export.h"
#include "estimation/report/hand_end.h"

namespace handsight {
namespace {

/// The rig as the model's effects move it; what drifts is the mount, never the rig.
std::optional<Rig> moved_cameras(const Chain& chain, const PredictionModel& model) {
  if (!chain.rig) return std::nullopt;
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(chain.joints.size()));
  return moved_rig(*chain.rig, moved_sites(states_at(chain, zero), model.effects));
}

}  // namespace

CalibratedRobot with_moved_hand(CalibratedRobot robot) {
  if (!robot.of_hand) return robot;
  robot.chain = chain_of_hand(robot.chain);
  robot.model = std::move(*robot.of_hand);
  robot.of_hand.reset();
  std::swap(robot.tcp, robot.mount);
  robot.notes.push_back(
      message("The sensor rides on the hand: what is told is where link {} is.", in_quotes(robot.tcp)));
  return robot;
}

CalibratedRobot calibrated_robot(const Session& session, const Fit& fit, const FitReport& reported,
                                 const FitOptions& options, const std::string& software,
                                 const ModelUncertainty& model_uncertainty) {
  CalibratedRobot robot;
  robot.chain = make_chain(session);
  robot.joint_names = session.joints;
  robot.tcp = session.tcp;
  robot.mount = session.mount.link;
  robot.model = prediction_model(fit, model_uncertainty);
  if (hand_carries_sensor(robot.chain)) robot.of_hand = model_of_hand(fit, model_uncertainty);
  robot.times = list_times(session);
  for (const Observation& o : session.observations)
    if (is_used(o)) robot.positions.push_back(o.position);
  robot.calibration = make_calibration(session, fit, reported, options, software, model_uncertainty);
  robot.rig = moved_cameras(robot.chain, robot.model);
  robot.notes = unknown_texts(session, fit);
  if (robot.model.repeatability.observations < 3)
    robot.notes.emplace_back(
        "Fewer than three observations show three markers: how the real TCP scatters about the model is not known, and "
        "sigma leaves it out.");
  return robot;
}

CalibratedRobot calibrated_robot(const Calibration& c, Robot urdf, const std::string& robot_file,
                                 const std::string& file) {
  if (c.tcp.empty() || c.joints.empty())
    throw InputError(message(
        "{}: has no <robot> with the tcp link or no <joints> with their order; predict from its session.", file));
  Session session;
  session.file = file;
  session.robot_file = robot_file;
  session.robot = std::move(urdf);
  session.tcp = c.tcp;
  session.mount.link = c.mount;
  session.gravity = c.gravity.value_or(session.gravity);
  session.joints = c.joints;
  CalibratedRobot robot;
  robot.joint_names = c.joints;
  robot.tcp = c.tcp;
  robot.mount = c.mount;
  robot.model = prediction_model(c, session.robot);
  session.marker_count = std::max(static_cast<int>(c.markers.size()), count_markers(robot.model.effects));
  robot.chain = make_chain(session);
  if (hand_carries_sensor(robot.chain)) robot.of_hand = model_of_hand(c, robot.chain);
  robot.times = c.times;
  robot.positions = c.positions;
  robot.calibration = c;
  robot.notes = c.notes;
  if (!c.effects.empty() && !c.model_covariance)
    robot.notes.emplace_back(
        "The file does not say how the errors of TCP->Body and of the effects go together (<model_covariance>): sigma "
        "takes them as independent and is too large.");
  return robot;
}

bool is_calibration_file(const std::filesystem::path& path) {
  return !std::filesystem::is_directory(path) && read_file(path).find("<handsight_calibration") != std::string::npos;
}

}  // namespace handsight
