// SPDX-License-Identifier: Apache-2.0
// The body frame: a function of the markers alone (thesis 4.16-4.18).
#pragma once

#include <optional>
#include <vector>

#include "geometry/rigid.h"

namespace handsight {

/// Two markers and the direction between them: from `from` to `to`.
struct BodySide {
  int from = 0;
  int to = 0;
};

/// Which sides span the frame: x along `longest`, `second` the provisional y. Decided once, at the first estimate, and
/// kept, so that nearly equal sides cannot make the frame jump. With two markers only `longest`, with one neither.
struct BodySides {
  std::vector<int> markers;  // that have a position, ascending: their centroid is the origin
  std::optional<BodySide> longest, second;
};

/// The sides for these marker positions (m, any frame); markers without a position are left out. Sides are looked
/// at in the order of thesis (4.16), neighbours first: 0-1, 1-2, ..., 0-2, ...; of equal ones the first is taken; a
/// second side along the longest (within 1e-6 rad) is passed over.
BodySides choose_sides(const std::vector<std::optional<Vector3>>& markers);

/// The body frame, with what it does not observe taken from `start` (with two markers the rotation about x, with one
/// every rotation).
struct BodyFrame {
  Rigid tcp_from_body;
  /// d xi / d markers, 6 x 3m, of the small motion xi in exp(xi) tcp_from_body; unobserved directions are zero.
  Eigen::MatrixXd motion_by_markers;
  /// The unobserved small motions, 6 x 0 to 3, unit rotations about lines through the origin of the body.
  Eigen::Matrix<double, 6, Eigen::Dynamic> unobserved;
};

/// `markers_in_tcp`: all markers, those not in `sides` are not read.
BodyFrame body_frame(const BodySides& sides, const std::vector<Vector3>& markers_in_tcp,
                     const Matrix3& start_rotation = Matrix3::Identity());

/// Covariance of xi from that of the markers (3m x 3m); an unobserved rotation gets the variance of an angle of which
/// nothing is known, pi^2 / 3.
Matrix6 body_covariance(const BodyFrame& frame, const Eigen::MatrixXd& marker_covariance);

/// Sigmas (m, rad) of the body's origin and of the rotations about the TCP's axes, from the covariance of xi in
/// exp(xi) tcp_from_body.
Eigen::Matrix<double, 6, 1> origin_sigma(const Rigid& tcp_from_body, const Matrix6& covariance);

}  // namespace handsight
