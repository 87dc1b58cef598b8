// SPDX-License-Identifier: Apache-2.0
#include "simulation/simulated_session.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

#include "base/bounds.h"
#include "chain/body_frame.h"
#include "session/pose_points.h"
#include "simulation/poses.h"
#include "simulation/shown_target.h"
#include "simulation/touches.h"

namespace handsight {
namespace {

/// The streams of random numbers, one a purpose, so that one more observation changes nothing before it.
enum Purpose : std::uint64_t {
  body_stream = 1,
  pose_stream = 2,
  time_stream = 3,
  noise_stream = 100,
  wrong_stream = 1 << 20,
  unseen_stream = 1 << 21
};

/// Markers on a slightly bent plane, spread round its middle; a longest side of about `size`, no two too near.
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

/// The normal of a flat body, so that it looks to the sensor in most of the session's observations.
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

/// A target somewhere on the hand, turned anyhow; its points are those of its poses.
ShownBody random_target(const Session& like, Random random) {
  const Vector3 place = 0.06 * random.gaussian3();
  const Rigid tcp_from_target{rotation_from_vector<double>(random.gaussian3()), place};
  ShownBody body;
  for (const Vector3& point : pose_shape(pose_lever(*like.pose_sensor)))
    body.markers_in_tcp.push_back(tcp_from_target * point);
  body.normal_in_tcp = tcp_from_target.rotation.col(2);
  return body;
}

struct World {
  const Chain& chain;
  const std::vector<EffectTerm>& effects;
  const std::vector<Curve>& curves;
  Rigid mount_from_sensor;
  std::optional<KnownShape> shape;
};

struct Ends {
  Rigid root_from_tcp, root_from_sensor;
};

Ends ends_at(const World& world, const ObservationState& c) {
  const ObservedEnds seen = observed_ends(c, moved_sites(c, world.effects, world.curves));
  return {seen.ends.root_from_tcp, seen.ends.root_from_mount * world.mount_from_sensor * seen.mount_motion};
}

/// Where the markers are in this observation, with the body's and the markers' own slips.
std::vector<Vector3> markers_at(const World& world, const ObservationState& c,
                                const std::vector<Vector3>& markers_in_tcp) {
  const Sites sites = moved_sites(c, world.effects, world.curves);
  const std::vector<Vector3>& lie =
      world.shape && world.shape->piece_count() == 1 ? world.shape->markers : markers_in_tcp;
  const std::vector<std::optional<Vector3>> known(lie.begin(), lie.end());
  const Rigid tcp_from_body = body_frame(choose_sides(known), markers_in_tcp).tcp_from_body;
  const Rigid body_from_tcp = inverse(tcp_from_body), slipped = tcp_from_body * small_motion<double>(sites.body);
  std::vector<Vector3> markers;
  for (std::size_t m = 0; m < markers_in_tcp.size(); ++m)
    markers.push_back(slipped * (body_from_tcp * markers_in_tcp[m] + sites.markers[m]));
  return markers;
}

/// A marker, or for -1 the TCP, in the frame of what is touched.
Vector3 place_at_fixture(const World& world, const Session& like, const ObservationState& c, int fixture, int marker,
                         const std::vector<Vector3>& markers_in_tcp) {
  World at_fixture = world;
  const Mount& mount = fixture == 0 ? like.mount : like.other_mounts[static_cast<std::size_t>(fixture - 1)];
  at_fixture.mount_from_sensor = mount.mount_from_sensor;
  const Ends ends = ends_at(at_fixture, c);
  const Vector3 in_tcp =
      marker < 0 ? Vector3(Vector3::Zero()) : markers_at(world, c, markers_in_tcp)[static_cast<std::size_t>(marker)];
  return inverse(ends.root_from_sensor) * (ends.root_from_tcp * in_tcp);
}

Vector2 noisy(const Vector2& pixel, double noise, Random& random) {
  const double u = random.gaussian(), v = random.gaussian();
  return pixel + noise * Vector2(u, v);
}

/// Cameras that stand round a hand see markers from behind, which nobody sees.
bool faces(const Vector3& normal, const Vector3& in_camera, double most_turned) {
  return -normal.dot(in_camera) >= std::cos(most_turned) * in_camera.norm();
}

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

void measure_poses(const Session& like, const SimulationOptions& options, SimulatedSession& s) {
  const double lever = pose_lever(*like.pose_sensor), sigma = s.noise;
  for (std::size_t k = 0; k < s.session.observations.size(); ++k)
    s.session.observations[k].target_pose = measured_pose(s, k, lever, Random(options.seed).child(noise_stream + k));
  const bool is_reported = options.declare_noise && sigma > 0;
  s.session.pose_sensor = PoseSensor{};
  if (is_reported) s.session.pose_sensor = PoseSensor{sigma, sigma / lever};
  show_poses(s.session, lever);
}

/// Some markers taken out, some of the other image points put where the detector took another corner for the marker's.
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

/// Changes what was measured or where things were in observation `k`.
void disturb(const Disturbance& d, const World& world, SimulatedSession& s, std::size_t k) {
  Observation& o = s.session.observations[k];
  if (d.kind == Disturbance::Kind::marker) {
    const Vector3 along = (s.normal_in_tcp.unitOrthogonal() + 0.3 * s.normal_in_tcp).normalized();
    s.markers[k][static_cast<std::size_t>(d.index)] += d.size * along;
    return;
  }
  const auto named = std::find(s.session.joints.begin(), s.session.joints.end(), d.name);
  if (named == s.session.joints.end())
    throw InputError(
        message("Disturbance of observation {}: the joint \"{}\" is not named in <joints>.", d.id, d.name));
  const Eigen::Index j = named - s.session.joints.begin();
  if (d.kind == Disturbance::Kind::joint) {
    o.position[j] += d.size;
    return;
  }
  Eigen::VectorXd later = o.position;
  later[j] += d.size;
  const Ends ends = ends_at(world, states_at(world.chain, later));
  s.later_root_from_tcp[k] = ends.root_from_tcp;
  s.later_root_from_sensor[k] = ends.root_from_sensor;
}

void add_observations(const Session& like, const SimulationOptions& options, const World& world, SimulatedSession& s) {
  const Random root(options.seed);
  Random poses = root.child(pose_stream), times = root.child(time_stream);
  ShownBody body{s.markers_in_tcp, s.normal_in_tcp, s.normals_in_tcp};
  if (like.target) body = outermost(like, body);
  PoseSampler sampler(like, world.chain, body, options);
  double time = 0;
  for (int k = 0; k < options.observations; ++k) {
    time += times.uniform(3, 6);
    Observation o;
    o.id = k;
    o.time = std::round(1e3 * time) / 1e3;
    o.position = sampler.next(poses);
    o.velocity.resize(o.position.size());
    for (Eigen::Index j = 0; j < o.velocity.size(); ++j) o.velocity[j] = std::round(1e6 * 0.2 * times.gaussian()) / 1e6;
    s.session.observations.push_back(o);
  }
}

/// Where things truly were in the session's observations.
void place_observations(const World& world, SimulatedSession& s) {
  for (const ObservationState& c : observation_states(s.session, world.chain)) {
    const Ends ends = ends_at(world, c);
    s.root_from_tcp.push_back(ends.root_from_tcp);
    s.root_from_sensor.push_back(ends.root_from_sensor);
    s.markers.push_back(markers_at(world, c, s.markers_in_tcp));
  }
}

/// A probe's tips, some 15 cm before the TCP.
ShownBody random_probe(int count, Random random) {
  ShownBody body;
  for (int m = 0; m < count; ++m) {
    const double x = random.gaussian(), y = random.gaussian(), z = random.gaussian();
    body.markers_in_tcp.emplace_back(0.02 * x, 0.02 * y, 0.15 + 0.01 * z);
  }
  return body;
}

/// Every fixture stands where `like` says; a joint that is disturbed was so while the fixture was touched.
void add_touches(const Session& like, const SimulationOptions& options, const World& world,
                 const std::vector<Observation>* given, SimulatedSession& s) {
  if (options.wrong_corners > 0 || !options.shift_in_sensor.isZero())
    throw InputError("A session of touches has no image points and no sensor; leave --wrong-corners and --shift out.");
  const ShownBody body{s.markers_in_tcp, s.normal_in_tcp, {}};
  PoseSampler sampler(like, world.chain, body, options);
  Random postures = Random(options.seed).child(pose_stream);
  const TouchSimulation touches{like, world.chain, options,
                                [&](const ObservationState& c, int fixture, int marker) {
                                  return place_at_fixture(world, like, c, fixture, marker, s.markers_in_tcp);
                                },
                                [&] { return sampler.next(postures); }};
  if (given)
    read_touches(touches, s.session.observations);
  else
    s.session.observations = simulated_touches(touches);
  declare_touches(options, s.session);
  place_observations(world, s);
  s.later_root_from_tcp = s.root_from_tcp;
  s.later_root_from_sensor = s.root_from_sensor;
  for (const Disturbance& d : options.disturbances) {
    if (d.kind != Disturbance::Kind::joint || d.id < 0 || d.id >= options.observations)
      throw InputError(
          message("Disturbance of observation {}: of touches only joints can be disturbed, in observations 0 to {}.",
                  d.id, options.observations - 1));
    disturb(d, world, s, static_cast<std::size_t>(d.id));
  }
  for (std::size_t k = 0; k < s.session.observations.size(); ++k) spoil_sightings(options, k, s);
}

/// `given`: the observations' postures and times; null: they are drawn.
SimulatedSession simulated(const Session& like, const SimulationOptions& options,
                           const std::vector<Observation>* given) {
  const Chain chain = make_chain(like);
  const World world{chain, options.effects, options.curves, like.mount.mount_from_sensor, like.shape};
  SimulatedSession s;
  s.session = like;
  s.session.source.reset();
  s.session.observations.clear();
  s.session.notes.clear();
  s.session.title = options.title;
  s.effects = options.effects;
  s.mount_from_sensor = like.mount.mount_from_sensor;
  const bool tracker = like.is_tracker();
  if (tracker && options.wrong_corners > 0)
    throw InputError("A tracker session has no image points; leave --wrong-corners out.");
  s.noise = options.noise ? *options.noise
            : tracker     ? like.sigma_point.value_or(like.is_touch() ? 2e-5 : 2e-4)
                          : like.sigma_pixel.value_or(0.2);
  (tracker ? s.session.sigma_point : s.session.sigma_pixel) =
      options.declare_noise && s.noise > 0 ? std::optional(s.noise) : std::nullopt;
  const ShownBody body =
      !options.markers_in_tcp.empty() ? given_body(like, chain, options.markers_in_tcp)
      : like.target
          ? shown_target(like, options, like.target->sigma.value_or(2e-4), Random(options.seed).child(body_stream))
      : like.is_touch()  ? random_probe(like.marker_count, Random(options.seed).child(body_stream))
      : like.pose_sensor ? random_target(like, Random(options.seed).child(body_stream))
                         : random_body(like.marker_count, options.body_size, Random(options.seed).child(body_stream));
  s.markers_in_tcp = body.markers_in_tcp;
  s.normal_in_tcp = body.normal_in_tcp;
  s.normals_in_tcp = body.normals_in_tcp;

  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(chain.joints.size()));
  if (like.rig) s.true_rig = moved_rig(*like.rig, moved_sites(states_at(chain, zero), options.effects));
  if (given) s.session.observations = *given;
  if (like.is_touch()) {
    add_touches(like, options, world, given, s);
    return s;
  }
  if (!given) add_observations(like, options, world, s);
  place_observations(world, s);
  s.later_root_from_tcp = s.root_from_tcp;
  s.later_root_from_sensor = s.root_from_sensor;
  for (const Disturbance& d : options.disturbances) {
    if (d.id < 0 || d.id >= options.observations ||
        (d.kind == Disturbance::Kind::marker && d.index >= like.marker_count))
      throw InputError(message("Disturbance of observation {}: there are observations 0 to {} and markers 0 to {}.",
                               d.id, options.observations - 1, like.marker_count - 1));
    if (d.kind == Disturbance::Kind::right_image && like.rig && like.rig->count() < 2)
      throw InputError(message("Disturbance of observation {}: right_image needs a second camera.", d.id));
    disturb(d, world, s, static_cast<std::size_t>(d.id));
  }
  const Random root(options.seed);
  if (like.pose_sensor) {
    measure_poses(like, options, s);
    return s;
  }
  for (std::size_t k = 0; k < s.session.observations.size(); ++k) {
    s.session.observations[k].sightings =
        sightings_of(s, k, options.shift_in_sensor, options.most_turned, root.child(noise_stream + k));
    spoil_sightings(options, k, s);
  }
  return s;
}

}  // namespace

SimulatedSession simulate_session(const Session& like, const SimulationOptions& options) {
  return simulated(like, options, nullptr);
}

SimulatedSession simulate_at(const Session& like, const SimulationOptions& options,
                             const std::vector<Observation>& given) {
  SimulationOptions of_given = options;
  of_given.observations = static_cast<int>(given.size());
  return simulated(like, of_given, &given);
}

Disturbance parse_disturbance(const std::string& text, const Robot& robot) {
  auto refuse = [&]() -> InputError {
    return InputError(message(
        "Disturbance \"{}\": write ID:joint:NAME=RAD, ID:marker:INDEX=METRES or ID:right_image:NAME=RAD.", text));
  };
  const auto first = text.find(':');
  const auto second = first == std::string::npos ? first : text.find(':', first + 1);
  const auto equals = second == std::string::npos ? second : text.find('=', second + 1);
  if (equals == std::string::npos) throw refuse();
  Disturbance d;
  auto number = [&](std::size_t from, std::size_t to, auto& value) {
    const auto [stop, error] = std::from_chars(text.data() + from, text.data() + to, value);
    if (error != std::errc() || stop != text.data() + to) throw refuse();
  };
  number(0, first, d.id);
  number(equals + 1, text.size(), d.size);
  if (!bounds::joint.hold(d.size)) throw refuse();
  const std::string kind = text.substr(first + 1, second - first - 1);
  d.name = text.substr(second + 1, equals - second - 1);
  if (kind == "marker") {
    d.kind = Disturbance::Kind::marker;
    number(second + 1, equals, d.index);
    return d;
  }
  if (kind != "joint" && kind != "right_image") throw refuse();
  d.kind = kind == "joint" ? Disturbance::Kind::joint : Disturbance::Kind::right_image;
  if (find_joint(robot, d.name) < 0)
    throw InputError(message("Disturbance \"{}\": the robot has no joint \"{}\".", text, d.name));
  return d;
}

}  // namespace handsight
