// SPDX-License-Identifier: Apache-2.0
// Where the hand is, and what to command.
#include "base/files.h"
#include "correct/robot_file.h"
#include "handsight/correct.h"
#include "handsight/handsight.h"
#include "robot/urdf.h"
#include "session/calibration_xml.h"

namespace handsight {
namespace {

/// The robot whose hand is meant; `moved` holds it where that is another than the one that was given.
const CalibratedRobot& hand_of(const CalibratedRobot& robot, CalibratedRobot& moved) {
  if (!robot.of_hand) return robot;
  return moved = with_moved_hand(robot);
}

/// At rest, and from nowhere.
ObservationState pose_at(const CalibratedRobot& robot, const Eigen::VectorXd& position) {
  if (position.size() != static_cast<Eigen::Index>(robot.joint_names.size()))
    throw InputError(message("The position has {} numbers; expected {}, one for each joint: {}.", position.size(),
                             robot.joint_names.size(), fmt::join(robot.joint_names, " ")));
  if (!position.allFinite())
    throw InputError("The position holds a number that is not finite (nan or inf); expected angles in rad (m).");
  return states_at(robot.chain, position);
}

}  // namespace

const char* version() { return HANDSIGHT_VERSION; }

CalibratedRobot calibrated_robot(const Session& session, const Improvement& m) {
  return with_robot_file(
      calibrated_robot(session, m.last.model.fit, m.last.report, m.last.model_options,
                       std::string("handsight ") + version(), m.inclusion_probabilities.model_uncertainty),
      session);
}

CalibratedRobot read_calibrated_robot(const std::filesystem::path& calibration, const std::filesystem::path& urdf) {
  return with_robot_file(
      calibrated_robot(read_calibration(calibration), read_urdf(urdf), urdf.string(), calibration.string()), urdf);
}

void save_calibration(const std::filesystem::path& file, const CalibratedRobot& robot) {
  write_calibration(file, robot.calibration);
}

TcpPrediction predict(const CalibratedRobot& robot, const Eigen::VectorXd& position) {
  CalibratedRobot moved;
  const CalibratedRobot& hand = hand_of(robot, moved);
  return predict_tcp(pose_at(hand, position), hand.model);
}

std::vector<TcpPrediction> predict(const CalibratedRobot& robot, const std::vector<Eigen::VectorXd>& positions) {
  CalibratedRobot moved;
  const CalibratedRobot& hand = hand_of(robot, moved);
  std::vector<TcpPrediction> all;
  all.reserve(positions.size());
  for (const Eigen::VectorXd& position : positions) all.push_back(predict_tcp(pose_at(hand, position), hand.model));
  return all;
}

ExportedFile export_robot(const CalibratedRobot& robot, const std::string& kind, const ExportOptions& options) {
  return exported_file(robot, kind, options);
}

ExportedFile save_robot(const std::filesystem::path& file, const CalibratedRobot& robot, const std::string& kind) {
  ExportedFile written = export_robot(robot, kind, {.file = std::filesystem::absolute(file), .lerobot = {}});
  replace_file(file, written.text);
  return written;
}

Correction correct(const CalibratedRobot& robot, const Eigen::VectorXd& position,
                   const std::optional<Rigid>& root_from_tcp) {
  CalibratedRobot moved;
  const CalibratedRobot& hand = hand_of(robot, moved);
  return corrected(pose_at(hand, position), hand.model, root_from_tcp);
}

}  // namespace handsight
