// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/selection/hand_places.h"

#include <algorithm>

#include "estimation/problem/problem_part.h"

namespace handsight {
namespace {

constexpr std::size_t most_looked_at = 400;  // observations

Vector3 mean_shift(const ProblemObservation& o) {
  Vector3 sum = Vector3::Zero();
  if (o.marker_shifts.empty() || o.sightings.empty()) return sum;
  for (const Sighting& s : o.sightings) sum += o.marker_shifts[static_cast<std::size_t>(s.marker)];
  return sum / static_cast<double>(o.sightings.size());
}

std::vector<int> cameras_of(const ProblemObservation& o) {
  std::vector<int> cameras;
  for (const Sighting& s : o.sightings)
    for (const CameraPoint& p : s.in_cameras)
      if (std::find(cameras.begin(), cameras.end(), p.camera) == cameras.end()) cameras.push_back(p.camera);
  std::sort(cameras.begin(), cameras.end());
  return cameras;
}

/// What one camera tells of a point that it sees there: the same depth along its line of sight.
std::optional<Vector3> at_depth(const Camera& camera, const Vector2& pixel, double depth) {
  const auto direction = undistort(camera, pixel);
  return direction ? std::optional(Vector3(depth * direction->x(), depth * direction->y(), depth)) : std::nullopt;
}

/// Where the cameras of `by` place the point x (first camera's frame, m) as those of `seen` see it.
std::optional<Vector3> reported_by(const Rig& by, const Rig& seen, const std::vector<int>& cameras, const Vector3& x) {
  std::vector<View> views;
  for (const int c : cameras) {
    const Vector3 x_in_camera = seen.at(c).camera_from_first * x;
    if (x_in_camera.z() <= 0) return std::nullopt;
    views.push_back({&by.at(c).camera, &by.at(c).camera_from_first, project(seen.at(c).camera, x_in_camera)});
  }
  if (views.size() == 1) {
    const Rigid& there = *views[0].camera_from_first;
    const auto point = at_depth(*views[0].camera, views[0].pixel, (there * x).z());
    return point ? std::optional<Vector3>(inverse(there) * *point) : std::nullopt;
  }
  const auto point = triangulate(views);
  return point ? std::optional(point->point) : std::nullopt;
}

}  // namespace

HandPlaces::HandPlaces(const Fit& fit) : fit_(fit) {
  const std::size_t count = fit.problem.observations.size(), stride = (count + most_looked_at - 1) / most_looked_at;
  std::size_t place = 0;
  part_ = take_part(fit.problem, [&](const ProblemObservation&) { return place++ % stride == 0; });
  part_.columns_of_effects.clear();
  part_.with_motions = false;
  now_ = with(list_terms(fit));
}

Eigen::Matrix3Xd HandPlaces::moved_by(const std::vector<EffectTerm>& terms) {
  Eigen::Matrix3Xd moved = with(terms) - now_;
  if (!fit_.problem.mount_is_estimated) return moved;
  const Vector3 mean = moved.rowwise().mean();
  moved.colwise() -= mean;
  return moved;
}

Eigen::Matrix3Xd HandPlaces::with(const std::vector<EffectTerm>& terms) {
  part_.terms = terms;
  if (part_.rig) part_.rig = part_.source->chain.rig;  // where no effect is left, none puts it back
  place_observations(part_);
  Eigen::Matrix3Xd places(3, static_cast<Eigen::Index>(part_.observations.size()));
  for (Eigen::Index i = 0; i < places.cols(); ++i)
    places.col(i) = reported_place(part_.observations[static_cast<std::size_t>(i)]);
  return places;
}

Vector3 HandPlaces::reported_place(const ProblemObservation& o) const {
  Vector3 place = sensor_from_tcp_at(o, estimate(fit_)) * Vector3(fit_.tcp_from_body.translation + mean_shift(o));
  if (!fit_.problem.rig || !part_.rig) return place;
  return reported_by(*fit_.problem.rig, *part_.rig, cameras_of(o), place).value_or(place);
}

}  // namespace handsight
