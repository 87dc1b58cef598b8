// SPDX-License-Identifier: Apache-2.0
#include "estimation/problem/target_pose.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "targets/homography.h"

namespace handsight {
namespace {

/// The plane that points lie in: its frame has z across it.
struct Plane {
  Rigid target_from_plane;
  bool is_flat = false;
};

Plane plane_of(const std::vector<Sighting>& sightings, const std::vector<Vector3>& places) {
  Vector3 center = Vector3::Zero();
  for (const Sighting& s : sightings)
    center += places[static_cast<std::size_t>(s.marker)] / static_cast<double>(sightings.size());
  Matrix3 spread = Matrix3::Zero();
  for (const Sighting& s : sightings) {
    const Vector3 off = places[static_cast<std::size_t>(s.marker)] - center;
    spread += off * off.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Matrix3> eigen(spread);
  Plane plane;
  plane.target_from_plane.translation = center;
  Matrix3& axes = plane.target_from_plane.rotation;
  axes.col(0) = eigen.eigenvectors().col(2);
  axes.col(2) = eigen.eigenvectors().col(0);
  axes.col(1) = axes.col(2).cross(axes.col(0));
  plane.is_flat = eigen.eigenvalues()[0] < 1e-4 * eigen.eigenvalues()[1];
  return plane;
}

/// The motion that a homography from the plane to rays (x', y', 1) is made of.
std::optional<Rigid> make_motion(const Matrix3& homography) {
  const double scale = std::sqrt(homography.col(0).norm() * homography.col(1).norm());
  if (!(scale > 0)) return std::nullopt;
  Matrix3 columns = homography / scale;
  if (columns(2, 2) < 0) columns = -columns;
  Rigid motion;
  motion.translation = columns.col(2);
  columns.col(2) = columns.col(0).cross(columns.col(1));
  motion.rotation = nearest_rotation(columns);
  if (!motion.rotation.allFinite() || !motion.translation.allFinite()) return std::nullopt;
  return motion;
}

/// The other pose that a flat target looks nearly alike in: its normal mirrored about the line of sight.
Rigid tilted_back(const Rigid& camera_from_plane) {
  const Vector3 normal = camera_from_plane.rotation.col(2), sight = camera_from_plane.translation.normalized();
  const Vector3 mirrored = 2 * normal.dot(sight) * sight - normal;
  const Matrix3 turn = turn_between(normal, mirrored).toRotationMatrix();
  return {turn * camera_from_plane.rotation, camera_from_plane.translation};
}

struct Ray {
  int marker;
  Vector2 ray;
};

std::vector<Ray> rays_of(const Rig& rig, const std::vector<Sighting>& sightings, int camera) {
  std::vector<Ray> rays;
  for (const Sighting& s : sightings)
    if (const CameraPoint* seen = seen_by(s, camera))
      if (const auto ray = undistort(rig.at(camera).camera, seen->pixel)) rays.push_back({s.marker, *ray});
  return rays;
}

/// Two poses of the target by sightings that lie in a plane: as their homography says, and the tilt mirrored.
std::vector<Rigid> poses_by_plane(const Rig& rig, const std::vector<Sighting>& flat,
                                  const std::vector<Vector3>& places) {
  int best = 0;
  std::vector<Ray> rays;
  for (int c = 0; c < rig.count(); ++c)
    if (auto seen = rays_of(rig, flat, c); seen.size() > rays.size()) rays = std::move(seen), best = c;
  const Plane plane = plane_of(flat, places);
  if (rays.size() < 4 || !plane.is_flat) return {};
  const Rigid plane_from_target = inverse(plane.target_from_plane);
  std::vector<PlacePixel> pairs;
  for (const Ray& r : rays)
    pairs.push_back({(plane_from_target * places[static_cast<std::size_t>(r.marker)]).head<2>(), r.ray});
  const auto homography = linear_homography(pairs);
  const auto camera_from_plane = homography ? make_motion(*homography) : std::nullopt;
  if (!camera_from_plane) return {};
  const Rigid first_from_camera = inverse(rig.at(best).camera_from_first);
  return {first_from_camera * *camera_from_plane * plane_from_target,
          first_from_camera * tilted_back(*camera_from_plane) * plane_from_target};
}

/// Runs of neighbouring points that lie in a plane, four or more each: the faces of a body. All points where they are
/// flat.
std::vector<std::vector<Sighting>> flat_runs(const std::vector<Sighting>& sightings,
                                             const std::vector<Vector3>& places) {
  constexpr std::size_t fewest = 4, most_runs = 8;
  if (plane_of(sightings, places).is_flat) return {sightings};
  std::vector<std::vector<Sighting>> runs;
  for (std::size_t first = 0; first + fewest <= sightings.size() && runs.size() < most_runs;) {
    const auto from = sightings.begin() + static_cast<std::ptrdiff_t>(first);
    std::vector<Sighting> run(from, from + fewest);
    if (!plane_of(run, places).is_flat) {
      ++first;
      continue;
    }
    for (first += fewest; first < sightings.size(); ++first) {
      run.push_back(sightings[first]);
      if (plane_of(run, places).is_flat) continue;
      run.pop_back();
      break;
    }
    runs.push_back(std::move(run));
  }
  return runs;
}

bool is_same_turn(const BodyPose& a, const BodyPose& b) {
  const Rigid apart = inverse(a.sensor_from_body) * b.sensor_from_body;
  return vector_from_rotation(apart.rotation).norm() < 1e-3;
}

std::optional<TargetPose> by_one_camera(const Rig& rig, const std::vector<Sighting>& sightings,
                                        const std::vector<Vector3>& places) {
  std::vector<BodyPose> found;
  for (const std::vector<Sighting>& flat : flat_runs(sightings, places))
    for (const Rigid& start : poses_by_plane(rig, flat, places))
      if (const auto pose = estimate_body_pose(&rig, sightings, places, start)) found.push_back(*pose);
  if (found.empty()) return std::nullopt;
  std::sort(found.begin(), found.end(), [](const BodyPose& a, const BodyPose& b) { return a.cost < b.cost; });
  TargetPose result{found.front()};
  const auto other =
      std::find_if(found.begin(), found.end(), [&](const BodyPose& p) { return !is_same_turn(found.front(), p); });
  if (other != found.end()) result.lead = other->cost / std::max(found.front().cost, 1e-300);
  return result;
}

}  // namespace

std::optional<TargetPose> target_pose(const Rig* rig, const std::vector<Sighting>& sightings,
                                      const std::vector<Vector3>& places) {
  if (const auto start = body_pose_from_points(rig, sightings, places))
    if (const auto pose = estimate_body_pose(rig, sightings, places, *start)) return TargetPose{*pose};
  return rig ? by_one_camera(*rig, sightings, places) : std::nullopt;
}

}  // namespace handsight
