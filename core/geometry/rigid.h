// SPDX-License-Identifier: Apache-2.0
// Rigid motions, rotation vectors, XYZ fixed angles and small motions. See docs/conventions.md.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>

namespace handsight {

template <class T>
using Vector3T = Eigen::Matrix<T, 3, 1>;
template <class T>
using Matrix3T = Eigen::Matrix<T, 3, 3>;
template <class T>
using Vector6T = Eigen::Matrix<T, 6, 1>;

using Vector2 = Eigen::Vector2d;
using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;
using Matrix4 = Eigen::Matrix4d;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// A rigid motion `b_from_a`: x_in_b = rotation * x_in_a + translation. Metres; the rotation is orthonormal.
template <class T>
struct RigidT {
  Matrix3T<T> rotation = Matrix3T<T>::Identity();
  Vector3T<T> translation = Vector3T<T>::Zero();
};
using Rigid = RigidT<double>;

/// Products of rotations and vectors as plain sums, each compiled once for all its uses; written as an expression of
/// Eigen every source would compile each of them again. The sums run in the order in which Eigen's pairs of doubles add
/// up (the last row by itself), so that either way gives the same bits.
inline Vector3 rotated(const Matrix3& m, const Vector3& v) {
  const double *a = m.data(), *x = v.data();
  return {(a[0] * x[0] + a[3] * x[1]) + a[6] * x[2], (a[1] * x[0] + a[4] * x[1]) + a[7] * x[2],
          a[2] * x[0] + (a[5] * x[1] + a[8] * x[2])};
}
/// By the transpose of `m`.
inline Vector3 rotated_back(const Matrix3& m, const Vector3& v) {
  const double *a = m.data(), *x = v.data();
  return {(a[0] * x[0] + a[1] * x[1]) + a[2] * x[2], (a[3] * x[0] + a[4] * x[1]) + a[5] * x[2],
          (a[6] * x[0] + a[7] * x[1]) + a[8] * x[2]};
}
inline Matrix3 product(const Matrix3& m, const Matrix3& n) {
  Matrix3 result;
  const double *a = m.data(), *b = n.data();
  double* c = result.data();
  for (int j = 0; j < 9; j += 3) {
    c[j] = (a[0] * b[j] + a[3] * b[j + 1]) + a[6] * b[j + 2];
    c[j + 1] = (a[1] * b[j] + a[4] * b[j + 1]) + a[7] * b[j + 2];
    c[j + 2] = a[2] * b[j] + (a[5] * b[j + 1] + a[8] * b[j + 2]);
  }
  return result;
}
inline Vector3 sum(const Vector3& a, const Vector3& b) {
  return {a.data()[0] + b.data()[0], a.data()[1] + b.data()[1], a.data()[2] + b.data()[2]};
}

/// c_from_a = c_from_b * b_from_a
inline Rigid operator*(const Rigid& c_from_b, const Rigid& b_from_a) {
  return {product(c_from_b.rotation, b_from_a.rotation),
          sum(rotated(c_from_b.rotation, b_from_a.translation), c_from_b.translation)};
}
template <class T>
RigidT<T> operator*(const RigidT<T>& c_from_b, const RigidT<T>& b_from_a) {
  return {c_from_b.rotation * b_from_a.rotation, c_from_b.rotation * b_from_a.translation + c_from_b.translation};
}

/// x_in_b = b_from_a * x_in_a
template <class T>
Vector3T<T> operator*(const RigidT<T>& b_from_a, const Vector3T<T>& x_in_a) {
  return b_from_a.rotation * x_in_a + b_from_a.translation;
}

/// For expressions of Eigen too, from which the template cannot deduce its scalar.
inline Vector3 operator*(const Rigid& b_from_a, const Vector3& x_in_a) {
  return sum(rotated(b_from_a.rotation, x_in_a), b_from_a.translation);
}

inline Rigid inverse(const Rigid& b_from_a) {
  const double* a = b_from_a.rotation.data();
  const Vector3 back = rotated_back(b_from_a.rotation, b_from_a.translation);
  Rigid a_from_b;
  double* c = a_from_b.rotation.data();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) c[i + 3 * j] = a[j + 3 * i];
  a_from_b.translation = {-back.data()[0], -back.data()[1], -back.data()[2]};
  return a_from_b;
}

template <class T>
RigidT<T> inverse(const RigidT<T>& b_from_a) {
  return {b_from_a.rotation.transpose(), -(b_from_a.rotation.transpose() * b_from_a.translation)};
}

template <class T>
RigidT<T> cast(const Rigid& motion) {
  return {motion.rotation.cast<T>(), motion.translation.cast<T>()};
}

template <class T>
Matrix3T<T> cross_matrix(const Vector3T<T>& v) {
  Matrix3T<T> m;
  m << T(0), -v.z(), v.y(), v.z(), T(0), -v.x(), -v.y(), v.x(), T(0);
  return m;
}

/// Exponential of a rotation vector (Rodrigues), rad; exact to rounding at every angle, series below 1e-4 rad.
template <class T>
Matrix3T<T> rotation_from_vector(const Vector3T<T>& v) {
  using std::cos;
  using std::sin;
  using std::sqrt;
  const T angle_squared = v.squaredNorm();
  T sine_ratio, cosine_ratio;  // sin(a)/a, (1 - cos(a))/a^2
  if (angle_squared < T(1e-8)) {
    sine_ratio = T(1) - angle_squared / T(6);
    cosine_ratio = T(0.5) - angle_squared / T(24);
  } else {
    const T angle = sqrt(angle_squared);
    const T half_sine = sin(angle / T(2));  // 1 - cos a = 2 sin^2(a/2): no cancellation
    sine_ratio = sin(angle) / angle;
    cosine_ratio = T(2) * half_sine * half_sine / angle_squared;
  }
  // The cross matrix squared is v v^T - |v|^2.
  Matrix3T<T> rotation = v * (cosine_ratio * v).transpose() + cross_matrix<T>(v * sine_ratio);
  rotation.diagonal().array() += T(1) - angle_squared * cosine_ratio;
  return rotation;
}

/// Rotation about a unit axis by an angle in rad.
template <class T>
Matrix3T<T> rotation_about(const Vector3& unit_axis, const T& angle) {
  using std::cos;
  using std::sin;
  const T sine = sin(angle), versine = T(1) - cos(angle);
  const Matrix3 along = unit_axis * unit_axis.transpose() - Matrix3::Identity();  // the cross matrix squared
  return Matrix3T<T>::Identity() + cross_matrix<double>(unit_axis).template cast<T>() * sine +
         along.template cast<T>() * versine;
}

/// The rotation vector of a rotation matrix, of length 0 to pi; near pi its sign is one of the two.
Vector3 vector_from_rotation(const Matrix3& rotation);

/// XYZ fixed angles (Craig; thesis 2.3, with the order of its printed matrix corrected): Rz(yaw) Ry(pitch) Rx(roll).
Matrix3 rotation_from_rpy(const Vector3& roll_pitch_yaw);

/// The inverse: pitch in [-pi/2, pi/2]; where |pitch| is pi/2 the roll is 0.
Vector3 rpy_from_rotation(const Matrix3& rotation);

/// The shortest rotation that carries the direction of `a` to that of `b`; of opposite ones a half turn about any axis
/// across them.
Eigen::Quaterniond turn_between(const Vector3& a, const Vector3& b);

/// The nearest rotation to a matrix (polar decomposition by SVD, determinant +1).
Matrix3 nearest_rotation(const Matrix3& matrix);

/// A small motion (translation first, then the rotation vector): translation as it is, rotation its exponential.
/// This is not the SE(3) exponential; to first order, and so for covariances, the two agree.
template <class T>
RigidT<T> small_motion(const Vector6T<T>& v) {
  return {rotation_from_vector<T>(v.template tail<3>()), v.template head<3>()};
}

/// Left Jacobian of the rotation group: exp(w + d) = exp(J d) exp(w) to first order.
Matrix3 left_jacobian(const Vector3& rotation_vector);

/// The 6x6 matrix J with small_motion(v + d) = exp(J d) small_motion(v) to first order, J d as a motion rate (v, w) of
/// x' = v + w cross x.
Matrix6 small_motion_jacobian(const Vector6& v);

/// The small motion v with small_motion(v) * a = b; rotation part of length 0 to pi.
Vector6 small_motion_between(const Rigid& a, const Rigid& b);

/// The 6x6 matrix that carries a motion rate (v, w) in frame a to the same motion's rate in frame b: for
/// x' = v + w cross x in a, the same field written in b.
Matrix6 adjoint(const Rigid& b_from_a);

/// Row by row 4x4 matrix of the motion.
Matrix4 matrix_from_rigid(const Rigid& motion);

/// The rigid motion b_from_a that carries points `in_a` (3 x n) nearest to `in_b` in least squares with weights
/// (n, >= 0), n >= 3 and not on a line for a unique answer (Umeyama / Kabsch, reflections excluded).
Rigid align_points(const Eigen::Matrix3Xd& in_b, const Eigen::Matrix3Xd& in_a, const Eigen::VectorXd& weights);

}  // namespace handsight
