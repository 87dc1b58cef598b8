// SPDX-License-Identifier: Apache-2.0
#include "estimation/start/start_by_points.h"

#include <algorithm>

#include "estimation/problem/problem_part.h"
#include "estimation/solvers/inverse_parts.h"
#include "estimation/solvers/least_squares.h"
#include "estimation/start/multi_start.h"
#include "estimation/start/start_markers.h"

namespace handsight {
namespace {

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

/// Where no marker is seen as a point (one camera), and nothing is known of the mount: rotations all round compete.
std::optional<Unknowns> start_by_rays(const Problem& problem) {
  Problem alone = problem;
  hold_effects(alone);
  const auto markers = static_cast<std::size_t>(problem.marker_count);
  const auto starts = competing_starts(alone, Unknowns{std::vector<Vector3>(markers, Vector3::Zero()), Rigid{}, {}});
  return starts.empty() ? std::nullopt : std::optional(starts.front());
}

}  // namespace

std::optional<Unknowns> start_by_points(const Problem& problem, const Mount& mount) {
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

}  // namespace handsight
