// SPDX-License-Identifier: Apache-2.0
// Rigid motions as Ceres moves them. Internal to trust_region.cpp.
#pragma once

#include <ceres/manifold.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>

#include "geometry/rigid.h"

namespace handsight {

using MotionNumbers = std::array<double, 12>;  // the rotation column by column, then the translation
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Rows = Eigen::Map<RowMajor>;

inline MotionNumbers list_numbers(const Rigid& motion) {
  MotionNumbers numbers;
  Eigen::Map<Matrix3>(numbers.data()) = motion.rotation;
  Eigen::Map<Vector3>(numbers.data() + 9) = motion.translation;
  return numbers;
}

inline Rigid make_motion(const double* numbers) {
  return {Eigen::Map<const Matrix3>(numbers), Eigen::Map<const Vector3>(numbers + 9)};
}

/// Rigid motions that move by six numbers: X exp(v), as the mount does, or exp(v) X, as the body in the TCP frame.
class MotionManifold : public ceres::Manifold {
 public:
  explicit MotionManifold(bool from_left) : from_left_(from_left) {}
  int AmbientSize() const override { return 12; }
  int TangentSize() const override { return 6; }

  bool Plus(const double* x, const double* delta, double* sum) const override {
    const Rigid step = small_motion<double>(Vector6(Eigen::Map<const Vector6>(delta)));
    const MotionNumbers moved = list_numbers(from_left_ ? step * make_motion(x) : make_motion(x) * step);
    std::copy(moved.begin(), moved.end(), sum);
    return true;
  }
  bool Minus(const double* y, const double* x, double* difference) const override {
    const Rigid from = make_motion(x), to = make_motion(y);
    const Rigid step = from_left_ ? to * inverse(from) : inverse(from) * to;
    Eigen::Map<Vector6>(difference) << step.translation, vector_from_rotation(step.rotation);
    return true;
  }
  bool PlusJacobian(const double* x, double* jacobian) const override {
    Rows(jacobian, 12, 6) = by_step(x);
    return true;
  }
  bool MinusJacobian(const double* x, double* jacobian) const override {
    Rows(jacobian, 6, 12) = step_by_numbers(x);
    return true;
  }

  /// A left inverse of PlusJacobian: a derivative by the step times it is one by the twelve numbers.
  Eigen::Matrix<double, 6, 12> step_by_numbers(const double* x) const {
    const Eigen::Matrix<double, 12, 6> by = by_step(x);
    return Matrix6(by.transpose() * by).inverse() * by.transpose();
  }

 private:
  Eigen::Matrix<double, 12, 6> by_step(const double* x) const {
    const Rigid motion = make_motion(x);
    Eigen::Matrix<double, 12, 6> by = Eigen::Matrix<double, 12, 6>::Zero();
    for (int axis = 0; axis < 3; ++axis) {
      const Matrix3 turn = cross_matrix(Vector3(Vector3::Unit(axis)));
      Eigen::Map<Matrix3>(by.col(3 + axis).data()) = from_left_ ? turn * motion.rotation : motion.rotation * turn;
      if (from_left_) by.col(3 + axis).tail<3>() = turn * motion.translation;
    }
    by.bottomLeftCorner<3, 3>() = from_left_ ? Matrix3(Matrix3::Identity()) : motion.rotation;
    return by;
  }
  bool from_left_;
};

}  // namespace handsight
