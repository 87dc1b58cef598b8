// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "base/degrees.h"
#include "command.h"
#include "options/driven_poses.h"
#include "printing/json_values.h"
#include "printing/outputs.h"
#include "printing/reported_json.h"

namespace handsight::cli {
namespace {

struct PredictArguments {
  SourceOptions source;
  PoseOptions poses;
  Output output;
};

/// Where what was fitted at the hand (the camera on it, else the body) is, and its sigma: position (m), then rotation
/// (rad), root axes. The flange is taken as it is reported.
Vector6 carried_sigma(const TcpPrediction& p, const PredictionModel& model) {
  // root_from_carried = root_from_hand exp(xi) hand_from_carried: a motion about the hand's origin, told at its place.
  Matrix6 at_place = Matrix6::Identity();
  at_place.topRightCorner<3, 3>() = -cross_matrix(Vector3(model.tcp_from_body.translation));
  Matrix6 turned = Matrix6::Zero();
  turned.topLeftCorner<3, 3>() = turned.bottomRightCorner<3, 3>() = p.root_from_tcp_est.rotation;
  const Matrix6 covariance =
      turned * at_place * model.covariance.topLeftCorner<6, 6>() * at_place.transpose() * turned.transpose();
  return covariance.diagonal().cwiseMax(0).cwiseSqrt();
}

/// `--position` is "x y z roll pitch yaw" of the flange; the joints that stand for it are x y z yaw pitch roll.
std::vector<ObservationState> flange_poses(const PoseOptions& o, const CalibratedRobot& source) {
  if (o.positions.empty() && o.file.empty())
    throw InputError(
        "No pose of the flange is given; give --position \"x y z roll pitch yaw\" (m and rad) or --positions "
        "FILE.csv.");
  std::vector<ObservationState> poses = driven_poses(o, source);
  for (std::size_t i = 0; i < o.positions.size(); ++i)
    std::swap(poses[i].sensor[source.chain.joints[3]], poses[i].sensor[source.chain.joints[5]]);
  return poses;
}

int run_of_flange(const PredictArguments& o, const CalibratedRobot& source) {
  const bool carries_sensor = source.calibration.mount == source.tcp;
  const std::vector<ObservationState> poses = flange_poses(o.poses, source);
  Output::note(fmt::format(
      "There are no joints: the flange is taken as the robot tells it, and what is told is where {} on it is then.",
      carries_sensor ? "the sensor" : "the target"));
  o.output.line(
      "      x        y        z m     roll    pitch      yaw deg   sigma x  y  z mm       sigma rx  ry  rz deg");
  Json list = Json::array();
  for (const ObservationState& pose : poses) {
    const TcpPrediction p = predict_tcp(pose, source.model);
    const Vector3 t = p.root_from_body_est.translation,
                  rpy = degrees * rpy_from_rotation(p.root_from_body_est.rotation);
    const Vector6 s = carried_sigma(p, source.model);
    o.output.line(
        fmt::format("{:>8.4f} {:>8.4f} {:>8.4f} {:>9.3f} {:>8.3f} {:>8.3f}    {:>6.3f} {:>6.3f} {:>6.3f}    {:>7.4f} "
                    "{:>7.4f} {:>7.4f}",
                    t.x(), t.y(), t.z(), rpy.x(), rpy.y(), rpy.z(), 1e3 * s[0], 1e3 * s[1], 1e3 * s[2], degrees * s[3],
                    degrees * s[4], degrees * s[5]));
    Json reported = prediction_json(p, true);
    reported["sigma"] = numbers(s);
    list.push_back(reported);
  }
  o.output.json(list);
  return done;
}

int run(const PredictArguments& o) {
  note_input(o.poses.file);
  const CalibratedRobot source = with_moved_hand(predict_source(o.source));
  o.output.require_places();
  if (source.chain.robot.is_of_poses) return run_of_flange(o, source);
  const std::vector<ObservationState> poses = driven_poses(o.poses, source);
  Json list = Json::array();
  for (const Message& note : source.notes) Output::note(note);
  if (!source.model.rotation_is_observed)
    Output::note(
        "The markers do not show how the body is turned; sigma is that of the position, and rotations have none.");
  o.output.line("      x        y        z m     moved by mm   sigma x  y  z mm       sigma rx  ry  rz deg");
  for (const ObservationState& pose : poses) {
    const TcpPrediction p = predict_tcp(pose, source.model);
    const Vector3 t = p.root_from_tcp_est.translation;
    const Vector6 s = p.sigma();
    const bool turns = source.model.rotation_is_observed;
    const std::string rotation =
        turns ? fmt::format("{:>7.4f} {:>7.4f} {:>7.4f}", degrees * s[3], degrees * s[4], degrees * s[5])
              : fmt::format("{:>7} {:>7} {:>7}", "-", "-", "-");
    o.output.line(fmt::format("{:>8.4f} {:>8.4f} {:>8.4f} {:>12.3f}    {:>6.3f} {:>6.3f} {:>6.3f}    {}", t.x(), t.y(),
                              t.z(), 1e3 * (t - p.root_from_tcp.translation).norm(), 1e3 * s[0], 1e3 * s[1], 1e3 * s[2],
                              rotation));
    list.push_back(prediction_json(p, turns));
  }
  o.output.json(list);
  return done;
}

}  // namespace

Command add_predict(const CommandLine& program) {
  auto options = std::make_shared<PredictArguments>();
  const CommandLine command = program.command("predict", "Where the TCP really is in poses that were not measured");
  add_source_options(command, options->source);
  add_pose_options(command, options->poses);
  add_json_option(command, options->output);
  return {command, [options] { return run(*options); }};
}

}  // namespace handsight::cli
