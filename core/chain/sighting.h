// SPDX-License-Identifier: Apache-2.0
// One marker as one observation saw it: its residual and normal equations by the marker's position in the sensor's
// frame. Everything in the chain moves a measurement through that position (cameras and rig apart), so a fit needs
// no larger Jacobian than these three columns.
#pragma once

#include "camera/rig.h"
#include "session/session.h"

namespace handsight {

/// Two rows a camera, or three of a tracker's point. Of a size that is known beforehand: nothing is allocated.
constexpr int max_rows = 2 * max_cameras;
template <int Columns>
using SightingRows = Eigen::Matrix<double, Eigen::Dynamic, Columns, 0, max_rows, Columns>;
using SightingColumn = SightingRows<1>;

/// Residuals measured - predicted of one sighting: u v (px) of each camera that saw it, in their order, or x y z (m),
/// or the one coordinate along the sighting's direction, or what its reading tells.
/// Where the sighting has a sigma of its own they are times W, W^T W = usual_sigma^2
/// covariance^-1: all residuals then have the noise of a usual one. Far beyond the image and behind a camera the
/// prediction is `project_anywhere`'s: it grows with the angle to the axis, so that the residual leads back.
struct SightingResidual {
  SightingColumn error;
  SightingRows<3> by_point;  // d predicted / d x_in_sensor
  int rows = 0;
  bool in_front = true;  // false: the point lies behind a camera that claims to have seen it
};

/// Rows by the point's position as rows by a motion (v, w) of what it sits on in the sensor's frame, x' = v + w cross
/// x: [A | -A [x]x].
template <class Rows>
Eigen::Matrix<double, Rows::RowsAtCompileTime, 6, 0, Rows::MaxRowsAtCompileTime, 6> by_motion(
    const Rows& by_point, const Vector3& x_in_sensor) {
  Eigen::Matrix<double, Rows::RowsAtCompileTime, 6, 0, Rows::MaxRowsAtCompileTime, 6> rows(by_point.rows(), 6);
  rows << by_point, -by_point * cross_matrix(x_in_sensor);
  return rows;
}

/// `x_in_sensor` is the marker in the first camera's or tracker's frame (m); rig is null in a tracker session.
SightingResidual sighting_residual(const Rig* rig, const Sighting& sighting, const Vector3& x_in_sensor);

/// Derivative of an image sighting's rows by the numbers of the rig, laid out as camera/rig.h says: the motions
/// exp(v) camera_from_first (6 a camera but the first) and camera_numbers (8 a camera); rows as in SightingResidual.
using CameraColumns = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, max_rows, rig_number_count(max_cameras)>;
CameraColumns camera_columns(const Rig& rig, const Sighting& sighting, const Vector3& x_in_sensor);

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
SightingNormal sighting_normal(const Rig* rig, const Sighting& sighting, const Vector3& x_in_sensor);

/// Number of coordinates that a sighting measures: 2 a camera, 3 of a point, 1 of a point along a direction or by a
/// reading.
int row_count(const Sighting& sighting);

/// The marker in the first camera's frame by the rays of all cameras that saw it, weighed by the sigmas of their own in
/// units of the usual variance (covariance per px^2). Nothing as in camera/rig.h, and in a tracker session.
std::optional<SeenPoint> triangulate(const Rig& rig, const Sighting& sighting);

/// The same with all weighed alike.
std::optional<SeenPoint> triangulate_unweighed(const Rig& rig, const Sighting& sighting);

}  // namespace handsight
