// SPDX-License-Identifier: Apache-2.0
#include "geometry/rigid.h"

#include <Eigen/SVD>
#include <algorithm>
#include <numbers>

namespace handsight {

Vector3 vector_from_rotation(const Matrix3& rotation) {
  // By quaternion: well conditioned at every angle, unlike the arc cosine of the trace.
  Eigen::Quaterniond q(rotation);
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  const double sine = q.vec().norm();
  if (sine < 1e-12) return 2.0 * q.vec();
  return q.vec() * (2.0 * std::atan2(sine, q.w()) / sine);
}

Matrix3 rotation_from_rpy(const Vector3& roll_pitch_yaw) {
  return rotation_about(Vector3::UnitZ(), roll_pitch_yaw.z()) * rotation_about(Vector3::UnitY(), roll_pitch_yaw.y()) *
         rotation_about(Vector3::UnitX(), roll_pitch_yaw.x());
}

Vector3 rpy_from_rotation(const Matrix3& r) {
  const double cosine = std::hypot(r(0, 0), r(1, 0));
  const double pitch = std::atan2(-r(2, 0), cosine);
  if (cosine > 1e-12) return {std::atan2(r(2, 1), r(2, 2)), pitch, std::atan2(r(1, 0), r(0, 0))};
  // Gimbal lock: only the sum or difference of roll and yaw is defined; the roll is set to 0.
  return {0.0, pitch, std::atan2(-r(0, 1), r(1, 1))};
}

Eigen::Quaterniond turn_between(const Vector3& a, const Vector3& b) {
  const Vector3 from = a.normalized(), to = b.normalized();
  const double cosine = to.dot(from);
  Eigen::Quaterniond turn;
  if (cosine < -1.0 + 1e-12) {  // the cross product says nothing of the axis
    const double w2 = (1.0 + std::max(cosine, -1.0)) * 0.5;
    turn.w() = std::sqrt(w2);
    turn.vec() = from.unitOrthogonal() * std::sqrt(1.0 - w2);
    return turn;
  }
  const double twice_w = std::sqrt((1.0 + cosine) * 2.0);
  turn.vec() = from.cross(to) * (1.0 / twice_w);
  turn.w() = twice_w * 0.5;
  return turn;
}

Matrix3 nearest_rotation(const Matrix3& matrix) {
  const Eigen::JacobiSVD<Matrix3> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Vector3 signs = Vector3::Ones();
  signs.z() = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1.0 : 1.0;
  return svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
}

Matrix3 left_jacobian(const Vector3& v) {
  const double a2 = v.squaredNorm();
  const Matrix3 k = cross_matrix(v);
  if (a2 < 1e-8) return Matrix3::Identity() + (0.5 - a2 / 24) * k + (1.0 / 6 - a2 / 120) * k * k;
  const double a = std::sqrt(a2);
  const double half = std::sin(a / 2);
  return Matrix3::Identity() + 2 * half * half / a2 * k + (a - std::sin(a)) / (a2 * a) * k * k;
}

Matrix6 small_motion_jacobian(const Vector6& v) {
  Matrix6 j = Matrix6::Identity();
  j.bottomRightCorner<3, 3>() = left_jacobian(v.tail<3>());
  j.topRightCorner<3, 3>() = cross_matrix<double>(v.head<3>()) * j.bottomRightCorner<3, 3>();
  return j;
}

Vector6 small_motion_between(const Rigid& a, const Rigid& b) {
  const Rigid difference = b * inverse(a);
  Vector6 v;
  v << difference.translation, vector_from_rotation(difference.rotation);
  return v;
}

Matrix6 adjoint(const Rigid& b_from_a) {
  Matrix6 m;
  m << b_from_a.rotation, cross_matrix(b_from_a.translation) * b_from_a.rotation, Matrix3::Zero(), b_from_a.rotation;
  return m;
}

Matrix4 matrix_from_rigid(const Rigid& motion) {
  Matrix4 m = Matrix4::Identity();
  m.topLeftCorner<3, 3>() = motion.rotation;
  m.topRightCorner<3, 1>() = motion.translation;
  return m;
}

Rigid align_points(const Eigen::Matrix3Xd& in_b, const Eigen::Matrix3Xd& in_a, const Eigen::VectorXd& weights) {
  const double total = weights.sum();
  const Vector3 center_b = in_b * weights / total;
  const Vector3 center_a = in_a * weights / total;
  const Matrix3 covariance =
      (in_b.colwise() - center_b) * weights.asDiagonal() * (in_a.colwise() - center_a).transpose();
  const Matrix3 rotation = nearest_rotation(covariance);
  return {rotation, center_b - rotation * center_a};
}

}  // namespace handsight
