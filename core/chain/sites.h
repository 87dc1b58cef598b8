// SPDX-License-Identifier: Apache-2.0
// The sites of the measurement chain at which an effect may act. All zero: the nominal chain.
#pragma once

#include <array>
#include <vector>

#include "camera/rig.h"
#include "robot/posture.h"

namespace handsight {

/// How a camera is not as calibrated.
template <class T>
struct CameraChangeT {
  Vector6T<T> motion = Vector6T<T>::Zero();  // exp(motion) * camera_from_first; the first camera has none
  Eigen::Matrix<T, camera_number_count, 1> numbers =
      Eigen::Matrix<T, camera_number_count, 1>::Zero();  // of camera_numbers, added

  bool is_zero() const { return motion.isZero(T(0)) && numbers.isZero(T(0)); }
};
using CameraChange = CameraChangeT<double>;

template <class T>
struct SitesT {
  RobotChangeT<T> robot;                              // joints, gravity, payload, the root's spring
  Vector6T<T> mount = Vector6T<T>::Zero();            // mount_from_sensor * exp(mount)
  Vector6T<T> drift = Vector6T<T>::Zero();            // ... * exp(drift), after `mount`
  std::array<CameraChangeT<T>, max_cameras> cameras;  // by camera of the rig
  Vector6T<T> hand = Vector6T<T>::Zero();             // root_from_tcp * exp(hand)
  Vector6T<T> body = Vector6T<T>::Zero();             // tcp_from_body * exp(body)
  std::vector<Vector3T<T>> markers;                   // m, in the body frame; empty: none
};
using Sites = SitesT<double>;

}  // namespace handsight
