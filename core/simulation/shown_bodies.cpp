// SPDX-License-Identifier: Apache-2.0
#include "simulation/shown_bodies.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "session/pose_points.h"

namespace handsight {

ShownBody random_body(int count, double size, Random random) {
  ShownBody body;
  // Drawn one by one: the order of a call's arguments, operands of an operator included, is the compiler's.
  const double z = random.gaussian(), y = random.gaussian(), x = random.gaussian();
  body.normal_in_tcp = Vector3(x, y, z).normalized();
  const Vector3 across = body.normal_in_tcp.unitOrthogonal();
  const Vector3 along = body.normal_in_tcp.cross(across);
  const double off_along = 0.02 * random.gaussian(), off_across = 0.02 * random.gaussian();
  const Vector3 center = 0.04 * body.normal_in_tcp + off_across * across + off_along * along;
  const double start = random.uniform(0, 2 * std::numbers::pi);
  for (int i = 0; i < count; ++i) {
    // A ring with one marker nearer and one farther: sides of different length, so that the frame is well chosen.
    const double angle = start + 2 * std::numbers::pi * (i + 0.25 * random.uniform(-1, 1)) / std::max(count, 2);
    const double radius = count == 1 ? 0 : size * (0.45 + 0.2 * (i % 3) / 2.0 + 0.05 * random.uniform(-1, 1));
    body.markers_in_tcp.push_back(center + radius * (std::cos(angle) * across + std::sin(angle) * along) +
                                  0.1 * size * random.uniform(-1, 1) * body.normal_in_tcp);
  }
  return body;
}

ShownBody given_body(const Session& like, const Chain& chain, const std::vector<Vector3>& markers) {
  ShownBody body{markers};
  Vector3 middle = Vector3::Zero();
  for (const Vector3& m : markers) middle += m / static_cast<double>(markers.size());
  Matrix3 spread = Matrix3::Zero();
  for (const Vector3& m : markers) spread += (m - middle) * (m - middle).transpose();
  body.normal_in_tcp = Eigen::SelfAdjointEigenSolver<Matrix3>(spread).eigenvectors().col(0);
  double toward = 0;
  for (const Observation& o : like.observations) {
    const Rigid from_tcp = sensor_from_tcp(chain_ends(chain, o.position), like.mount.mount_from_sensor);
    toward -= (from_tcp.rotation * body.normal_in_tcp).dot(from_tcp * middle);
  }
  if (toward < 0) body.normal_in_tcp = -body.normal_in_tcp;
  return body;
}

ShownBody random_target(const Session& like, Random random) {
  const Vector3 place = 0.06 * random.gaussian3();
  const Rigid tcp_from_target{rotation_from_vector<double>(random.gaussian3()), place};
  ShownBody body;
  for (const Vector3& point : pose_shape(pose_lever(*like.pose_sensor)))
    body.markers_in_tcp.push_back(tcp_from_target * point);
  body.normal_in_tcp = tcp_from_target.rotation.col(2);
  return body;
}

ShownBody random_probe(int count, Random random) {
  ShownBody body;
  for (int m = 0; m < count; ++m) {
    const double x = random.gaussian(), y = random.gaussian(), z = random.gaussian();
    body.markers_in_tcp.emplace_back(0.02 * x, 0.02 * y, 0.15 + 0.01 * z);
  }
  return body;
}

}  // namespace handsight
