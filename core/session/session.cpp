// SPDX-License-Identifier: Apache-2.0
#include "session/session.h"

#include <algorithm>
#include <cmath>

#include "base/median.h"

namespace handsight {

std::filesystem::path folder(const Session& session) {
  const std::filesystem::path parent = session.file.parent_path();
  return parent.empty() ? "." : parent;
}

bool Session::is_touch() const {
  const bool one_hand = std::all_of(parts.begin(), parts.end(), [](const SessionPart& p) { return p.body == 0; });
  return !fixtures.empty() && fixtures.size() == parts.size() && one_hand;
}

const SessionPart& part_of_fixture(const Session& session, int fixture) {
  return *std::find_if(session.parts.begin(), session.parts.end(),
                       [&](const SessionPart& p) { return p.fixture == fixture; });
}

const Mount& find_mount(const Session& session, int mount) {
  return mount == 0 ? session.mount : session.other_mounts[static_cast<std::size_t>(mount - 1)];
}

const char* device_tag(const Session& session) {
  if (session.is_touch()) return "touch";
  if (!session.rig) return session.pose_sensor ? "pose_sensor" : "tracker";
  return is_left_and_right(*session.rig) ? "stereo" : "cameras";
}

const CameraPoint* seen_by(const Sighting& sighting, int camera) {
  for (const CameraPoint& p : sighting.in_cameras)
    if (p.camera == camera) return &p;
  return nullptr;
}

CameraPoint* seen_by(Sighting& sighting, int camera) {
  for (CameraPoint& p : sighting.in_cameras)
    if (p.camera == camera) return &p;
  return nullptr;
}

void see(Sighting& sighting, int camera, const Vector2& pixel, const std::optional<PixelSigma>& sigma) {
  auto& points = sighting.in_cameras;
  const auto at = std::find_if(points.begin(), points.end(), [&](const CameraPoint& p) { return p.camera >= camera; });
  if (at != points.end() && at->camera == camera)
    *at = {camera, pixel, sigma};
  else
    points.insert(at, CameraPoint{camera, pixel, sigma});
}

void forget(Sighting& sighting, int camera) {
  auto& points = sighting.in_cameras;
  points.erase(std::remove_if(points.begin(), points.end(), [&](const CameraPoint& p) { return p.camera == camera; }),
               points.end());
}

Sighting seen_at(int marker, const Vector2& first, const std::optional<Vector2>& second, MarkedBy by) {
  Sighting s{.marker = marker, .by = by};
  see(s, 0, first);
  if (second) see(s, 1, *second);
  return s;
}

/// The tags of a body that are placed within sigmas.
static std::vector<ShapePart> placed_parts(const Target& target) {
  std::vector<ShapePart> parts;
  if (!has_places(target) || are_places_exact(target)) return parts;
  for (std::size_t k = 0; k < target.places.size(); ++k)
    parts.push_back({4 * static_cast<int>(k), 4, target.places[k].sigma, target.places[k].sigma_angle});
  return parts;
}

void set_target(Session& session, const Target& target) {
  session.target = target;
  KnownShape& shape = session.shape.emplace();
  shape.sigma = print_sigma(target);
  for (const TargetPoint& point : target_points(target)) {
    shape.markers.push_back(point.position);
    shape.pieces.push_back(point.piece);
  }
  if (shape.pieces.back() == 0) shape.pieces.clear();
  shape.parts = placed_parts(target);
  session.marker_count = static_cast<int>(shape.markers.size());
}

bool needs_label(const Session& session) {
  const auto& all = session.observations;
  return session.rig && !session.target && std::any_of(all.begin(), all.end(), has_images) &&
         std::none_of(all.begin(), all.end(), [](const Observation& o) { return !o.sightings.empty(); });
}

bool has_images(const Observation& observation) {
  return std::any_of(observation.images.begin(), observation.images.end(), [](const auto& i) { return !i.empty(); });
}

bool is_used(const Observation& observation) {
  return !observation.sightings.empty() && observation.decision != Decision::rejected &&
         observation.decision != Decision::excluded;
}

double usual_sigma(const Session& session) {
  const std::optional<double>& declared = session.is_tracker() ? session.sigma_point : session.sigma_pixel;
  std::vector<double> reported;
  for (const Observation& o : session.observations)
    for (const Sighting& s : o.sightings) {
      for (const CameraPoint& p : s.in_cameras)
        if (p.sigma) reported.push_back(std::sqrt((p.sigma->u * p.sigma->u + p.sigma->v * p.sigma->v) / 2));
      if (s.point_sigma) reported.push_back(*s.point_sigma);
    }
  if (reported.empty()) return 0;
  if (declared) return *declared;
  return median(std::move(reported));
}

PixelSigma pixel_sigma(const Eigen::Matrix2d& covariance) {
  return {std::sqrt(covariance(0, 0)), std::sqrt(covariance(1, 1)), covariance(0, 1)};
}

Eigen::Matrix2d make_covariance(const PixelSigma& sigma) {
  return (Eigen::Matrix2d() << sigma.u * sigma.u, sigma.uv, sigma.uv, sigma.v * sigma.v).finished();
}

}  // namespace handsight
