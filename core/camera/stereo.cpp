// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Cholesky>
#include <cmath>

#include "camera/camera.h"

namespace handsight {
namespace {

/// Bouguet's linear start, thesis (4.14-4.15), in the left camera's frame.
std::optional<Vector3> bouguet_point(const StereoRig& rig, const Vector2& left, const Vector2& right) {
  const Vector3 left_ray = left.homogeneous();
  const Vector3 right_ray = right.homogeneous();
  Eigen::Matrix<double, 3, 2> a;
  a << -(rig.right_from_left.rotation * left_ray), right_ray;
  const Eigen::Matrix2d normal = a.transpose() * a;
  // Parallel rays: the determinant is (product of squared lengths) * sin^2 of the angle between them.
  if (normal.determinant() < 1e-14 * normal(0, 0) * normal(1, 1)) return std::nullopt;
  const Vector2 depths = normal.inverse() * (a.transpose() * rig.right_from_left.translation);
  if (!(depths.x() > 0 && depths.y() > 0)) return std::nullopt;
  return Vector3(depths.x() * left_ray);
}

}  // namespace

std::optional<StereoPoint> triangulate(const StereoRig& rig, const Vector2& left, const Vector2& right,
                                       const Eigen::Matrix2d& left_covariance,
                                       const Eigen::Matrix2d& right_covariance) {
  const auto left_normalised = undistort(rig.left, left);
  const auto right_normalised = undistort(rig.right, right);
  if (!left_normalised || !right_normalised) return std::nullopt;
  const auto start = bouguet_point(rig, *left_normalised, *right_normalised);
  if (!start) return std::nullopt;

  const Eigen::Matrix2d left_weight = left_covariance.inverse();
  const Eigen::Matrix2d right_weight = right_covariance.inverse();
  StereoPoint result;
  result.point = *start;
  Matrix3 information;
  for (int iteration = 0; iteration < 10; ++iteration) {
    const Vector3 in_right = rig.right_from_left * result.point;
    if (!(result.point.z() > 0 && in_right.z() > 0)) return std::nullopt;
    Matrix23 left_by_point, right_by_camera_point;
    const Vector2 left_error = left - project(rig.left, result.point, left_by_point);
    const Vector2 right_error = right - project(rig.right, in_right, right_by_camera_point);
    const Matrix23 right_by_point = right_by_camera_point * rig.right_from_left.rotation;
    information = left_by_point.transpose() * left_weight * left_by_point +
                  right_by_point.transpose() * right_weight * right_by_point;
    const Vector3 step = information.ldlt().solve(left_by_point.transpose() * left_weight * left_error +
                                                  right_by_point.transpose() * right_weight * right_error);
    result.point += step;
    if (!(step.norm() < 10 * start->norm())) return std::nullopt;
    if (step.norm() < 1e-12 * result.point.norm()) break;
  }
  if (!(result.point.z() > 0 && (rig.right_from_left * result.point).z() > 0)) return std::nullopt;
  result.covariance = information.inverse();
  result.epipolar_distance = epipolar_distance(rig, essential_matrix(rig), *left_normalised, *right_normalised);
  return result;
}

Matrix3 essential_matrix(const StereoRig& rig) {
  return cross_matrix(rig.right_from_left.translation) * rig.right_from_left.rotation;
}

double epipolar_distance(const StereoRig& rig, const Matrix3& essential, const Vector2& left_normalised,
                         const Vector2& right_normalised) {
  const Vector3 left_ray = left_normalised.homogeneous();
  const Vector3 right_ray = right_normalised.homogeneous();
  const Vector3 right_line = essential * left_ray;
  const Vector3 left_line = essential.transpose() * right_ray;
  const double gradient = std::sqrt(right_line.head<2>().squaredNorm() + left_line.head<2>().squaredNorm());
  if (gradient < 1e-300) return 0;
  const double focal = 0.25 * (rig.left.fx + rig.left.fy + rig.right.fx + rig.right.fy);
  // Sampson's distance; times sqrt 2 it is the distance to the line in one image when the other is held fixed.
  return std::abs(right_ray.dot(right_line)) / gradient * focal * std::sqrt(2.0);
}

}  // namespace handsight
