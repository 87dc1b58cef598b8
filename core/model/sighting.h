// SPDX-License-Identifier: Apache-2.0
// One marker as one observation saw it: its residual and normal equations by the marker's position in the sensor's
// frame. Everything in the chain moves a measurement through that position (cameras and rig apart), so a fit needs
// no larger Jacobian than these three columns.
#pragma once

#include "camera/camera.h"
#include "session/session.h"

namespace handsight {

/// Residuals measured - predicted of one sighting: left u v, right u v (px), or x y z (m). Rows that were not
/// measured are left out. Where the sighting has a sigma of its own they are times W, W^T W = usual_sigma^2
/// covariance^-1: all residuals then have the noise of a usual one. Far beyond the image and behind a camera the
/// prediction is `project_anywhere`'s: it grows with the angle to the axis, so that the residual leads back.
struct SightingResidual {
  Eigen::Matrix<double, 4, 1> error = Eigen::Matrix<double, 4, 1>::Zero();
  Eigen::Matrix<double, 4, 3> by_point = Eigen::Matrix<double, 4, 3>::Zero();  // d predicted / d x_in_sensor
  int rows = 0;
  bool in_front = true;  // false: the point lies behind a camera that claims to have seen it
};

/// `x_in_sensor` is the marker in the left camera's or tracker's frame (m); rig is null in a tracker session.
SightingResidual sighting_residual(const StereoRig* rig, const Sighting& sighting, const Vector3& x_in_sensor);

/// Derivative of an image sighting's rows by the rig's motion (6: exp(v) right_from_left) and by the numbers fx fy cx
/// cy k1 k2 p1 p2 of the left and of the right camera (8 each); rows as in SightingResidual.
using CameraColumns = Eigen::Matrix<double, 4, 22>;
CameraColumns camera_columns(const StereoRig& rig, const Sighting& sighting, const Vector3& x_in_sensor);

/// Normal equations of one sighting: information = J^T W J, gradient = J^T W error, cost = error^T W error, by the
/// marker's position in the sensor's frame.
struct SightingNormal {
  Matrix3 information = Matrix3::Zero();
  Vector3 gradient = Vector3::Zero();
  double cost = 0;
  int rows = 0;
  bool in_front = true;
};

/// Unweighted (W = 1): px^2 or m^2.
SightingNormal sighting_normal(const StereoRig* rig, const Sighting& sighting, const Vector3& x_in_sensor);

/// Number of coordinates that a sighting measures: 0 to 4.
int row_count(const Sighting& sighting);

}  // namespace handsight
