// SPDX-License-Identifier: Apache-2.0
#include "estimation/start/start_markers.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "estimation/problem/problem_part.h"

namespace handsight {
namespace {

struct RaySum {
  Matrix3 information = Matrix3::Zero();
  Vector3 right = Vector3::Zero();

  void add_ray(const Vector3& origin, const Vector3& direction) {
    const Vector3 d = direction.normalized();
    const Matrix3 across = Matrix3::Identity() - d * d.transpose();
    information += across;
    right += across * origin;
  }
  void add_point(const Vector3& point) {
    information += Matrix3::Identity();
    right += point;
  }
};

void add_sighting(const Rig* rig, const Sighting& s, const Rigid& tcp_from_sensor, RaySum& sum) {
  if (s.point) return sum.add_point(tcp_from_sensor * *s.point);
  for (const CameraPoint& seen : s.in_cameras)
    if (const auto ray = undistort(rig->at(seen.camera).camera, seen.pixel)) {
      const Rigid tcp_from_camera = tcp_from_sensor * inverse(rig->at(seen.camera).camera_from_first);
      sum.add_ray(tcp_from_camera.translation, tcp_from_camera.rotation * ray->homogeneous());
    }
}

}  // namespace

Problem thinned(const Problem& problem, std::size_t most) {
  if (problem.observations.size() <= most) return problem;
  Problem thin = without_observations(problem);
  for (std::size_t i = 0; i < most; ++i)
    thin.observations.push_back(problem.observations[i * problem.observations.size() / most]);
  return thin;
}

std::vector<Matrix3> axis_rotations() {
  std::vector<Matrix3> all;
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 3; ++y)
      for (int signs = 0; signs < 4 && x != y; ++signs) {
        Matrix3 r = Matrix3::Zero();
        r(x, 0) = signs & 1 ? -1 : 1;
        r(y, 1) = signs & 2 ? -1 : 1;
        r.col(2) = r.col(0).cross(r.col(1));
        all.push_back(r);
      }
  return all;
}

std::vector<Vector3> start_markers(const Problem& problem, const Rigid& mount_from_sensor) {
  std::vector<RaySum> sums(static_cast<std::size_t>(problem.marker_count));
  for (const ProblemObservation& o : problem.observations) {
    const Rigid tcp_from_sensor = inverse(o.root_from_tcp) * (o.root_from_mount * mount_from_sensor);
    for (const Sighting& s : o.sightings)
      add_sighting(problem.rig_or_null(), s, tcp_from_sensor, sums[static_cast<std::size_t>(s.marker)]);
  }
  std::vector<Vector3> markers;
  for (const RaySum& sum : sums) {
    // A single ray leaves the depth open: the pseudo-inverse takes the point of the ray nearest to the TCP.
    const Eigen::SelfAdjointEigenSolver<Matrix3> eigen(sum.information);
    const Vector3& values = eigen.eigenvalues();
    const Vector3 inverse =
        values.unaryExpr([&](double v) { return v > 1e-9 * std::max(values[2], 1e-300) ? 1 / v : 0.0; });
    markers.push_back(eigen.eigenvectors() * inverse.asDiagonal() * eigen.eigenvectors().transpose() * sum.right);
  }
  return markers;
}

}  // namespace handsight
