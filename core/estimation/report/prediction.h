// SPDX-License-Identifier: Apache-2.0
// Where the TCP really is in poses that were not measured: the purpose of it all.
#pragma once

#include <functional>

#include "estimation/fit/fit_result.h"
#include "estimation/problem/problem.h"
#include "estimation/report/model_uncertainty.h"
#include "session/calibration.h"

namespace handsight {

/// How the real TCP scatters about the model's, learned from the observations of a fit.
struct TcpRepeatability {
  Matrix6 covariance = Matrix6::Zero();  // of tcp_from_tcp_est: translation (m) and rotation vector (rad), TCP axes
  int observations = 0;                  // that showed three markers
};

/// The covariance of tcp_from_tcp_est over the observations behind the noise with which each was measured (maximum
/// likelihood); zero where the model agrees with the measurements down to the noise (CovarianceKind::noise). With fewer
/// than three such observations nothing is known of it: zero, and `observations` says so.
TcpRepeatability tcp_repeatability(const Fit& fit);

/// The same of the deviations as another frame has them: `to_frame` carries a small motion there from the TCP's axes.
TcpRepeatability tcp_repeatability(const Fit& fit, const std::function<Matrix6(const ProblemObservation&)>& to_frame);

/// What a prediction is made from.
struct PredictionModel {
  std::vector<EffectTerm> effects;
  TcpRepeatability repeatability;
  Eigen::MatrixXd covariance = Matrix6::Zero();  // 6 + n: xi of TCP->Body, then every number of the effects in order
  Rigid tcp_from_body;
  std::optional<Rigid> mount_from_sensor;  // absent: a file that does not say where the sensor sits
  bool rotation_is_observed =
      true;  // false: with one or two markers the body's rotation is a convention, kept at its start
  ModelUncertainty model_uncertainty;  // of the effects that the model has, and of others
};

/// A rotation of the body of which nothing is known (more than a radian) is no error of where the TCP is: nothing was
/// learned from it. It is left out of the covariance.
PredictionModel prediction_model(const Fit& fit, const ModelUncertainty& model_uncertainty = {});

/// The same from an exported calibration. A file without <model_covariance> tells sigmas alone: TCP->Body and effects
/// are then taken as independent, which makes sigma too large. InputError where an effect cannot be in this robot.
PredictionModel prediction_model(const Calibration& calibration, const Robot& robot);

struct TcpPrediction {
  Rigid root_from_tcp;                        // as commanded: the nominal robot
  Rigid root_from_tcp_est;                    // with the effects of the model
  Rigid root_from_body_est;                   // the marker body, slipped as it has by then
  std::optional<Rigid> root_from_sensor_est;  // the camera or tracker, drifted as it has by then
  Matrix6 covariance = Matrix6::Zero();       // of root_from_tcp_est: position (m), then rotation (rad), in root axes

  Vector6 sigma() const { return covariance.diagonal().cwiseMax(0).cwiseSqrt(); }
};

/// For one pose, joints in the order of the chain. TCPest is tied to the body by the estimated TCP->Body (thesis 4.51):
/// its covariance is the scatter of the observations about the model, that of TCP->Body and the effects together, and
/// what the choice of the effects leaves open.
TcpPrediction predict_tcp(const Chain& chain, const Eigen::VectorXd& position, const PredictionModel& model);

/// The same for a pose of which it is known how and when the robot comes there.
TcpPrediction predict_tcp(const ObservationState& states, const PredictionModel& model);

}  // namespace handsight
