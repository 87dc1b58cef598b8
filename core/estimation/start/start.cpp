// SPDX-License-Identifier: Apache-2.0
#include "estimation/start/start.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <numbers>

#include "estimation/problem/problem_part.h"
#include "estimation/start/competition.h"
#include "estimation/start/shape_start.h"

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

/// The linear system of the unknown mount. Columns: 3 a marker, 9 of R (column by column), 3 of t; an equation is
/// root_from_mount^-1 root_from_tcp x - R p - t = 0, its root_from_tcp translation on the right.
struct MountSystem {
  Eigen::MatrixXd h;
  Eigen::VectorXd g;
};

MountSystem mount_system(const Problem& points) {
  const Eigen::Index mount = 3 * points.marker_count;
  MountSystem system{Eigen::MatrixXd::Zero(mount + 12, mount + 12), Eigen::VectorXd::Zero(mount + 12)};
  for (const ProblemObservation& o : points.observations) {
    const Rigid mount_from_tcp = inverse(o.root_from_mount) * o.root_from_tcp;
    for (const Sighting& s : o.sightings) {
      Eigen::Matrix<double, 3, 15> row;
      row << mount_from_tcp.rotation, -s.point->x() * Matrix3::Identity(), -s.point->y() * Matrix3::Identity(),
          -s.point->z() * Matrix3::Identity(), -Matrix3::Identity();
      const Eigen::Matrix<double, 15, 15> h = row.transpose() * row;
      const Eigen::Matrix<double, 15, 1> g = -row.transpose() * mount_from_tcp.translation;
      const Eigen::Index m = 3 * s.marker;
      system.h.block<3, 3>(m, m) += h.topLeftCorner<3, 3>();
      system.h.block<3, 12>(m, mount) += h.topRightCorner<3, 12>();
      system.h.block<12, 3>(mount, m) += h.bottomLeftCorner<12, 3>();
      system.h.block<12, 12>(mount, mount) += h.bottomRightCorner<12, 12>();
      system.g.segment<3>(m) += g.head<3>();
      system.g.segment<12>(mount) += g.tail<12>();
    }
  }
  return system;
}

/// Markers and t for a given R, linear.
Unknowns with_rotation(const MountSystem& system, int marker_count, const Matrix3& rotation) {
  const Eigen::Index m = 3 * marker_count;
  Eigen::MatrixXd h(m + 3, m + 3);
  Eigen::MatrixXd by_rotation(m + 3, 9);
  h << system.h.topLeftCorner(m, m), system.h.topRightCorner(m, 3), system.h.bottomLeftCorner(3, m),
      system.h.bottomRightCorner(3, 3);
  by_rotation << system.h.block(0, m, m, 9), system.h.block(m + 9, m, 3, 9);
  Eigen::VectorXd g(m + 3);
  g << system.g.head(m), system.g.tail(3);
  const Eigen::VectorXd x = pseudo_inverse(h) * (g - by_rotation * rotation.reshaped());
  Unknowns u;
  for (int i = 0; i < marker_count; ++i) u.markers_in_tcp.push_back(x.segment<3>(3 * i));
  u.mount_from_sensor = {rotation, x.tail<3>()};
  return u;
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

namespace {

/// Where no marker is seen as a point (one camera), and nothing is known of the mount: rotations all round compete.
std::optional<Unknowns> start_by_rays(const Problem& problem) {
  Problem alone = problem;
  hold_effects(alone);
  const auto markers = static_cast<std::size_t>(problem.marker_count);
  const auto starts = competing_starts(alone, Unknowns{std::vector<Vector3>(markers, Vector3::Zero()), Rigid{}, {}});
  return starts.empty() ? std::nullopt : std::optional(starts.front());
}

std::optional<Unknowns> start_without_effects(const Problem& problem, const Mount& mount) {
  if (auto start = start_by_shape(problem, mount)) return start;
  if (!mount.estimate) return Unknowns{start_markers(problem, mount.mount_from_sensor), mount.mount_from_sensor, {}};

  int left_out = 0;
  Problem points = thinned(as_points(problem, left_out), 60);
  hold_effects(points);
  if (points.observations.empty()) {
    if (!mount.known) return start_by_rays(problem);
    return Unknowns{start_markers(problem, mount.mount_from_sensor), mount.mount_from_sensor, {}};
  }
  const MountSystem system = mount_system(points);
  const Eigen::VectorXd relaxed = pseudo_inverse(system.h) * system.g;
  std::vector<Matrix3> rotations = axis_rotations();
  rotations.push_back(nearest_rotation(relaxed.segment<9>(3 * problem.marker_count).reshaped(3, 3)));
  if (mount.known) rotations.push_back(mount.mount_from_sensor.rotation);

  // A few steps from everywhere show which starts lead down; the best of them are followed to the end.
  std::vector<Solution> tried;
  for (const Matrix3& rotation : rotations)
    tried.push_back(solve(points, with_rotation(system, problem.marker_count, rotation), {.most_iterations = 6}));
  std::stable_sort(tried.begin(), tried.end(),
                   [](const Solution& a, const Solution& b) { return a.normal.cost < b.normal.cost; });
  std::optional<Solution> best;
  for (std::size_t i = 0; i < std::min<std::size_t>(6, tried.size()); ++i) {
    Solution s = solve(points, tried[i].unknowns, {.most_iterations = 40});
    if (!best || s.normal.cost < best->normal.cost) best = std::move(s);
  }
  // Markers that were never seen as points follow from the mount.
  const std::vector<Vector3> from_rays = start_markers(problem, best->unknowns.mount_from_sensor);
  for (std::size_t m = 0; m < from_rays.size(); ++m)
    if (!points.marker_is_seen[m]) best->unknowns.markers_in_tcp[m] = from_rays[m];
  return best->unknowns;
}

}  // namespace

std::optional<Unknowns> start_values(const Problem& problem, const Mount& mount) {
  std::optional<Unknowns> start = start_without_effects(problem, mount);
  if (start) start->effects = effect_values(problem);
  return start;
}

}  // namespace handsight
