// SPDX-License-Identifier: Apache-2.0
#include "simulation/simulated_sightings.h"

#include <algorithm>
#include <cmath>

#include "session/pose_points.h"
#include "simulation/poses.h"
#include "simulation/random_streams.h"

namespace handsight {
namespace {

Vector2 noisy(const Vector2& pixel, double noise, Random& random) {
  const double u = random.gaussian(), v = random.gaussian();
  return pixel + noise * Vector2(u, v);
}

/// Cameras that stand round a hand see markers from behind, which nobody sees.
bool faces(const Vector3& normal, const Vector3& in_camera, double most_turned) {
  return -normal.dot(in_camera) >= std::cos(most_turned) * in_camera.norm();
}

/// What a pose sensor says of the six points' pose.
Rigid measured_pose(const SimulatedSession& s, std::size_t k, double lever, Random random) {
  const std::vector<Vector3> shape = pose_shape(lever);
  Eigen::Matrix3Xd in_tcp(3, pose_markers), in_target(3, pose_markers);
  for (int m = 0; m < pose_markers; ++m) {
    in_tcp.col(m) = s.markers[k][static_cast<std::size_t>(m)];
    in_target.col(m) = shape[static_cast<std::size_t>(m)];
  }
  const Rigid tcp_from_target = align_points(in_tcp, in_target, Eigen::VectorXd::Ones(pose_markers));
  Rigid pose = inverse(s.root_from_sensor[k]) * s.root_from_tcp[k] * tcp_from_target;
  const double sigma = s.noise;
  pose.translation += sigma * random.gaussian3();
  pose.rotation = pose.rotation * rotation_from_vector<double>(sigma / lever * random.gaussian3());
  return pose;
}

}  // namespace

std::vector<Sighting> sightings_of(const SimulatedSession& s, std::size_t k, const Vector3& shift, double most_turned,
                                   Random random) {
  std::vector<Sighting> all;
  const Rigid sensor_from_tcp = inverse(s.root_from_sensor[k]) * s.root_from_tcp[k];
  const Rigid sensor_from_tcp_later = inverse(s.later_root_from_sensor[k]) * s.later_root_from_tcp[k];
  const ShownBody body{s.markers_in_tcp, s.normal_in_tcp, s.normals_in_tcp};
  const bool has_faces = !body.normals_in_tcp.empty();
  // Of a body one face is asked to be seen well; others are seen as long as their tags can be read.
  constexpr double readable = 1.15;  // rad
  if (has_faces) most_turned = std::max(most_turned, readable);
  for (int m = 0; m < s.session.marker_count; ++m) {
    const Vector3& marker = s.markers[k][static_cast<std::size_t>(m)];
    const Vector3 x = sensor_from_tcp * marker + shift;
    Sighting sighting{.marker = m};
    if (!s.session.rig) {
      const double a = random.gaussian(), b = random.gaussian(), c = random.gaussian();
      sighting.point = x + s.noise * Vector3(a, b, c);
      all.push_back(sighting);
      continue;
    }
    for (int c = 0; c < s.true_rig->count(); ++c) {
      const RigCamera& camera = s.true_rig->at(c);
      const Rigid& first_from_tcp = c == 0 ? sensor_from_tcp : sensor_from_tcp_later;
      const Vector3 in_camera = camera.camera_from_first * (first_from_tcp * marker + shift);
      const Vector2 pixel = noisy(project(camera.camera, in_camera), s.noise, random);
      if (!is_visible(camera.camera, in_camera)) continue;
      const Vector3 normal =
          camera.camera_from_first.rotation * (first_from_tcp.rotation * normal_at(body, static_cast<std::size_t>(m)));
      if ((has_faces || s.true_rig->count() > 2) && !faces(normal, in_camera, most_turned)) continue;
      see(sighting, c, pixel);
    }
    if (!sighting.in_cameras.empty()) all.push_back(sighting);
  }
  return all;
}

void measure_poses(const Session& like, const SimulationOptions& options, SimulatedSession& s) {
  const double lever = pose_lever(*like.pose_sensor), sigma = s.noise;
  for (std::size_t k = 0; k < s.session.observations.size(); ++k)
    s.session.observations[k].target_pose = measured_pose(s, k, lever, Random(options.seed).child(noise_stream + k));
  const bool is_reported = options.declare_noise && sigma > 0;
  s.session.pose_sensor = PoseSensor{};
  if (is_reported) s.session.pose_sensor = PoseSensor{sigma, sigma / lever};
  show_poses(s.session, lever);
}

void spoil_sightings(const SimulationOptions& options, std::size_t k, SimulatedSession& s) {
  Observation& o = s.session.observations[k];
  const Random root(options.seed);
  Random unseen = root.child(unseen_stream + k), wrong = root.child(wrong_stream + k);
  std::erase_if(o.sightings, [&](const Sighting&) { return unseen.uniform() < options.unseen; });
  for (Sighting& sighting : o.sightings)
    for (int c = 0; s.session.rig && c < s.session.rig->count(); ++c) {
      const bool spoilt = wrong.uniform() < options.wrong_corners;
      const double u = wrong.gaussian(), v = wrong.gaussian();
      CameraPoint* const point = seen_by(sighting, c);
      if (!spoilt || !point) continue;
      const Vector2 off = wrong_corner_size * Vector2(u, v);
      point->pixel += off;
      s.wrong_corners.push_back({o.id, sighting.marker, c, off});
    }
}

}  // namespace handsight
