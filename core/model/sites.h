// SPDX-License-Identifier: Apache-2.0
// The sites of the measurement chain at which an effect may act. All zero: the nominal chain.
#pragma once

#include <vector>

#include "robot/posture.h"

namespace handsight {

template <class T>
struct SitesT {
  RobotChangeT<T> robot;                                                // joints, gravity, payload, the root's spring
  Vector6T<T> mount = Vector6T<T>::Zero();                              // mount_from_sensor * exp(mount)
  Vector6T<T> drift = Vector6T<T>::Zero();                              // ... * exp(drift), after `mount`
  Vector6T<T> rig = Vector6T<T>::Zero();                                // exp(rig) * right_from_left
  Eigen::Matrix<T, 8, 1> left_camera = Eigen::Matrix<T, 8, 1>::Zero();  // fx fy cx cy k1 k2 p1 p2, added
  Eigen::Matrix<T, 8, 1> right_camera = Eigen::Matrix<T, 8, 1>::Zero();
  Vector6T<T> hand = Vector6T<T>::Zero();  // root_from_tcp * exp(hand)
  Vector6T<T> body = Vector6T<T>::Zero();  // tcp_from_body * exp(body)
  std::vector<Vector3T<T>> markers;        // m, in the body frame; empty: none
};
using Sites = SitesT<double>;

}  // namespace handsight
