// SPDX-License-Identifier: Apache-2.0
// The angle-axis objective (thesis 4.39-4.40): body poses of single observations against the chain.
#pragma once

#include "estimation/problem/problem.h"
#include "estimation/solvers/loss.h"
#include "geometry/rigid.h"

namespace handsight {

struct AngleAxisResult {
  Rigid tcp_from_body;
  Rigid mount_from_sensor;
  /// Of the covariance of (xi in exp(xi) tcp_from_body; v in mount_from_sensor exp(v) where it is estimated).
  Eigen::MatrixXd covariance_factor;
  double sigma_m = 0;  // the weights: the mean noise of one axis of a body pose
  double sigma_rad = 0;
  double rms_m = 0;  // what is left: root mean square over observations of the translation's length
  double rms_rad = 0;
  int used = 0;  // observations with a body pose
  bool converged = false;
};

/// Minimises the sum over observations of |t|^2/sigma_m^2 + |theta|^2/sigma_rad^2 of the motion that carries the
/// measured body pose onto the predicted one, taken at the body's origin and in the sensor's axes. m and rad are
/// weighed by the pose noise itself, averaged over the observations. `noise` is that of one coordinate (px or m). A
/// loss acts on the length of an observation's six numbers in those sigmas. Needs one observation with three markers at
/// least (three with an estimated mount); nothing otherwise.
std::optional<AngleAxisResult> fit_angle_axis(const Problem& problem, const std::vector<Vector3>& markers_in_body,
                                              const Rigid& start_tcp_from_body, const Rigid& start_mount_from_sensor,
                                              double noise, Loss loss = Loss::none);

}  // namespace handsight
