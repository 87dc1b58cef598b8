// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "camera/rig.h"

namespace handsight {

std::optional<StereoPoint> triangulate(const StereoRig& rig, const Vector2& left, const Vector2& right,
                                       const Eigen::Matrix2d& left_covariance,
                                       const Eigen::Matrix2d& right_covariance) {
  const Rigid reference;
  const View views[] = {{&rig.left, &reference, left, left_covariance},
                        {&rig.right, &rig.right_from_left, right, right_covariance}};
  const auto seen = triangulate(views);
  if (!seen) return std::nullopt;
  const auto left_normalised = undistort(rig.left, left), right_normalised = undistort(rig.right, right);
  return StereoPoint{seen->point, seen->covariance,
                     epipolar_distance(rig, essential_matrix(rig), *left_normalised, *right_normalised)};
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
