// SPDX-License-Identifier: Apache-2.0
#include "simulation/simulated_session.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "chain/body_frame.h"
#include "simulation/random_streams.h"
#include "simulation/shown_bodies.h"
#include "simulation/shown_target.h"
#include "simulation/simulated_sightings.h"
#include "simulation/touches.h"

namespace handsight {
namespace {

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

/// The body that is given, or one drawn by the seed.
ShownBody body_of(const Session& like, const Chain& chain, const SimulationOptions& options) {
  if (!options.markers_in_tcp.empty()) return given_body(like, chain, options.markers_in_tcp);
  const Random random = Random(options.seed).child(body_stream);
  if (like.target) return shown_target(like, options, like.target->sigma.value_or(2e-4), random);
  if (like.is_touch()) return random_probe(like.marker_count, random);
  if (like.pose_sensor) return random_target(like, random);
  return random_body(like.marker_count, options.body_size, random);
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
  const ShownBody body = body_of(like, chain, options);
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

std::optional<Observation> simulate_touch(const Session& like, const SimulationOptions& options,
                                          const std::vector<Observation>& given) {
  const Chain chain = make_chain(like);
  const World world{chain, options.effects, options.curves, like.mount.mount_from_sensor, like.shape};
  const std::vector<Vector3> markers = body_of(like, chain, options).markers_in_tcp;
  const TouchSimulation touches{like,
                                chain,
                                options,
                                [&](const ObservationState& c, int fixture, int marker) {
                                  return place_at_fixture(world, like, c, fixture, marker, markers);
                                },
                                {}};
  return next_touch(touches, given);
}

}  // namespace handsight
