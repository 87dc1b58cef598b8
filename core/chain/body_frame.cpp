// SPDX-License-Identifier: Apache-2.0
#include "chain/body_frame.h"

#include "base/error.h"
#include "chain/unknown_angle.h"

namespace handsight {

BodySides choose_sides(const std::vector<std::optional<Vector3>>& markers) {
  BodySides sides;
  for (std::size_t i = 0; i < markers.size(); ++i)
    if (markers[i]) sides.markers.push_back(static_cast<int>(i));
  const int count = static_cast<int>(sides.markers.size());

  std::vector<BodySide> all;
  for (int gap = 1; gap < count; ++gap)
    for (int i = 0; i + gap < count; ++i) all.push_back({sides.markers[i], sides.markers[i + gap]});
  auto make_vector = [&](const BodySide& s) { return Vector3(*markers[s.to] - *markers[s.from]); };
  auto longest_of = [&](auto&& allowed) {
    std::optional<BodySide> best;
    for (const BodySide& side : all)
      if (allowed(side) && (!best || make_vector(side).norm() > make_vector(*best).norm())) best = side;
    return best;
  };
  sides.longest = longest_of([&](const BodySide& s) { return make_vector(s).norm() > 0; });
  if (!sides.longest) return sides;
  const Vector3 x = make_vector(*sides.longest);
  sides.second = longest_of(
      [&](const BodySide& s) { return x.cross(make_vector(s)).norm() > 1e-6 * x.norm() * make_vector(s).norm(); });
  return sides;
}

namespace {

Vector3 side_vector(const BodySide& side, const std::vector<Vector3>& markers) {
  return markers[static_cast<std::size_t>(side.to)] - markers[static_cast<std::size_t>(side.from)];
}

/// d side / d markers, 3 x 3m
Eigen::MatrixXd side_by_markers(const BodySide& side, Eigen::Index columns) {
  Eigen::MatrixXd d = Eigen::MatrixXd::Zero(3, columns);
  d.middleCols<3>(3 * side.from) = -Matrix3::Identity();
  d.middleCols<3>(3 * side.to) = Matrix3::Identity();
  return d;
}

/// The rotation nearest to `start` whose x axis is `x`.
Matrix3 turn_x_to(const Matrix3& start, const Vector3& x) {
  return turn_between(start.col(0), x).toRotationMatrix() * start;
}

}  // namespace

BodyFrame body_frame(const BodySides& sides, const std::vector<Vector3>& markers, const Matrix3& start_rotation) {
  check(!sides.markers.empty(), "a body frame of {} markers", sides.markers.size());
  const Eigen::Index columns = 3 * static_cast<Eigen::Index>(markers.size());
  Vector3 center = Vector3::Zero();
  Eigen::MatrixXd center_by_markers = Eigen::MatrixXd::Zero(3, columns);
  const double share = 1.0 / static_cast<double>(sides.markers.size());
  for (const int m : sides.markers) {
    center += share * markers[static_cast<std::size_t>(m)];
    center_by_markers.middleCols<3>(3 * m) = share * Matrix3::Identity();
  }

  // Rotation rate w of the frame by the markers, thesis (4.16-4.17): x = a/|a|, z = a x b/|a x b|, y = z x x.
  Matrix3 rotation = start_rotation;
  Eigen::MatrixXd turn_by_markers = Eigen::MatrixXd::Zero(3, columns);
  std::vector<Vector3> free_axes;
  if (!sides.longest) {
    free_axes = {Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ()};
  } else {
    const Vector3 a = side_vector(*sides.longest, markers);
    const Eigen::MatrixXd a_by_markers = side_by_markers(*sides.longest, columns);
    if (sides.second) {
      const Vector3 b = side_vector(*sides.second, markers);
      const Vector3 normal = a.cross(b);
      rotation.col(0) = a.normalized();
      rotation.col(2) = normal.normalized();
      rotation.col(1) = rotation.col(2).cross(rotation.col(0));
      const Eigen::MatrixXd normal_by_markers =
          cross_matrix(a) * side_by_markers(*sides.second, columns) - cross_matrix(b) * a_by_markers;
      turn_by_markers += rotation.col(0) * (-rotation.col(1).transpose() * normal_by_markers / normal.norm());
    } else {
      rotation = turn_x_to(start_rotation, a.normalized());
      free_axes = {rotation.col(0)};
    }
    const Vector3 y = rotation.col(1), z = rotation.col(2);
    turn_by_markers += z * (y.transpose() * a_by_markers / a.norm()) - y * (z.transpose() * a_by_markers / a.norm());
  }

  BodyFrame frame;
  frame.tcp_from_body = {rotation, center};
  frame.motion_by_markers.resize(6, columns);
  // exp(xi) acts from the left, about the TCP's origin: the centre moves by v + w cross centre.
  frame.motion_by_markers << center_by_markers + cross_matrix(center) * turn_by_markers, turn_by_markers;
  frame.unobserved.resize(6, static_cast<Eigen::Index>(free_axes.size()));
  for (std::size_t i = 0; i < free_axes.size(); ++i)
    frame.unobserved.col(static_cast<Eigen::Index>(i)) << center.cross(free_axes[i]), free_axes[i];
  return frame;
}

Matrix6 body_covariance(const BodyFrame& frame, const Eigen::MatrixXd& marker_covariance) {
  return frame.motion_by_markers * marker_covariance * frame.motion_by_markers.transpose() +
         unknown_angle_variance * frame.unobserved * frame.unobserved.transpose();
}

Vector6 origin_sigma(const Rigid& tcp_from_body, const Matrix6& covariance) {
  Matrix6 at_origin = Matrix6::Identity();
  at_origin.topRightCorner<3, 3>() = -cross_matrix(tcp_from_body.translation);
  return (at_origin * covariance * at_origin.transpose()).diagonal().cwiseMax(0).cwiseSqrt();
}

}  // namespace handsight
