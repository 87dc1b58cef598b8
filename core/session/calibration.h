// SPDX-License-Identifier: Apache-2.0
// A calibration: what a fit found, as it is exported and read back. Plain data; in and out by
// calibration_xml.h.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/message.h"
#include "geometry/rigid.h"
#include "session/effect_definition.h"

namespace handsight {

/// A motion and the covariance of the small motion xi (x y z rx ry rz; m, rad) in small_motion(xi) * motion.
struct EstimatedMotion {
  Rigid motion;
  Matrix6 covariance = Matrix6::Zero();
};

/// Quality of the fit; what is unknown is absent. Pixels for stereo sessions, metres for tracker sessions.
struct CalibrationFit {
  int observations = 0, used = 0, rejected = 0;
  std::optional<double> rms_pixel, held_out_rms_pixel, noise_pixel;
  std::optional<double> rms_m, held_out_rms_m, noise_m;
  std::optional<double> chi2_per_dof;
};

/// One estimated number of an effect; `of` names the joint, link, marker or camera that it belongs to, if
/// any.
struct CalibrationParameter {
  std::string of;
  std::string name;
  double value = 0;
  std::optional<double> sigma;  // absent: unknown
  std::string unit;
};

/// Terms of one effect, at most one at each place. A model may hold several terms of one effect at one place (a slip
/// that came twice; a number that is held and estimated): then several of these have the same id, and all of them
/// count.
struct CalibrationEffect {
  std::string id;
  std::vector<CalibrationParameter> parameters;
};

/// What the choice of the effects leaves open, beside `model_covariance`.
struct CalibrationUncertainty {
  std::vector<CalibrationEffect> others;  // that may be there too; their values are 0, or choices
  Eigen::MatrixXd covariance;  // of xi, every parameter of Calibration::effects and every one of `others`, in order
};

struct Calibration {
  std::string session;   // title or name of the session that it comes from
  std::string created;   // ISO 8601, UTC
  std::string software;  // name and version
  EstimatedMotion tcp_from_body;
  CalibrationFit fit;
  std::vector<Vector3> markers;     // m, in the body frame
  std::vector<int> unseen_markers;  // indices of those that have no position: zero in `markers`, no element in the file
  std::vector<CalibrationEffect> effects;
  std::vector<EffectDefinition> definitions;  // of those effects that are no part of the catalogue

  // What a prediction without the session needs; empty or absent in files of other programs.
  std::string tcp;                           // link
  std::string mount;                         // link
  std::vector<std::string> joints;           // the order of a position
  std::optional<Vector3> gravity;            // m/s^2, in the root link's frame
  std::optional<Matrix6> tcp_repeatability;  // covariance of tcp_from_tcp_est (m, rad; TCP axes) over the observations
  /// (6 + n) square: xi of tcp_from_body, then every parameter of `effects` in their order; those held have zeros.
  std::optional<Eigen::MatrixXd> model_covariance;
  std::optional<CalibrationUncertainty> model_uncertainty;
  // Of a hand that carries the sensor, whose TCP link stands still: as the two above for xi of mount_from_sensor
  // (root_from_sensor = root_from_mount exp(xi) mount_from_sensor), and the scatter of the mount's link in its axes.
  std::optional<Eigen::MatrixXd> hand_covariance;
  std::optional<Matrix6> hand_repeatability;
  std::optional<EstimatedMotion> mount_from_sensor;  // where the fit estimated it
  std::vector<double> times;               // s, of all observations in order: what slips and drifts are placed by
  std::vector<Eigen::VectorXd> positions;  // rad or m: of the used observations in order, or of some spread over them

  /// Of a collection: each of its sessions by itself (its `session` is the title), the robot's effects in all of them;
  /// what stands beside is then that of the first.
  std::vector<Calibration> sessions;

  std::vector<Message> notes;  // what the reader ignored, a sentence each; not written
};

/// That of one session of a collection. InputError lists the titles where there is none of this one; of a calibration
/// of one session alone that it is no collection's.
const Calibration& find_session(const Calibration& calibration, const std::string& title);

}  // namespace handsight
