// SPDX-License-Identifier: Apache-2.0
// Sessions of a known truth that can be measured in further poses.
#pragma once

#include "diagnosis/planning/planning.h"
#include "fixtures/arms.h"
#include "simulation/random.h"
#include "simulation/simulated_session.h"

namespace handsight::fixture {

inline SimulatedSession simulated(const Session& like, int observations, std::uint64_t seed,
                                  const std::vector<EffectTerm>& effects = {}) {
  SimulationOptions o;
  o.observations = observations;
  o.seed = seed;
  o.effects = effects;
  return simulate_session(like, o);
}

/// Where the truth puts the markers in the sensor's frame in any pose (at rest).
inline std::vector<Vector3> true_markers(const SimulatedSession& s, const Chain& chain,
                                         const Eigen::VectorXd& position) {
  const ObservationState c = states_at(chain, position);
  const Rigid left_from_tcp = sensor_from_tcp(observed_ends(c, moved_sites(c, s.effects)).ends, s.mount_from_sensor);
  std::vector<Vector3> all;
  for (const Vector3& m : s.markers_in_tcp) all.push_back(left_from_tcp * m);
  return all;
}

/// The session with the truth's measurements in these poses added.
inline Session measured(const SimulatedSession& s, Session session, const std::vector<Eigen::VectorXd>& poses,
                        Random random) {
  const Chain chain = make_chain(s.session);
  for (const Eigen::VectorXd& pose : poses) {
    Observation o;
    o.id = session.observations.back().id + 1;
    o.time = session.observations.back().time + 4;
    o.position = pose;
    int marker = 0;
    for (const Vector3& x : true_markers(s, chain, pose)) {
      Sighting sighting{.marker = marker++};
      if (session.rig) {
        const auto noisy = [&](const Vector2& p) {
          const double u = random.gaussian(), v = random.gaussian();
          return Vector2(p + s.noise * Vector2(u, v));
        };
        see(sighting, 0, noisy(project(session.rig->at(0).camera, x)));
        see(sighting, 1, noisy(project(session.rig->at(1).camera, session.rig->at(1).camera_from_first * x)));
      } else {
        sighting.point = x + s.noise * random.gaussian3();
      }
      o.sightings.push_back(sighting);
    }
    session.observations.push_back(o);
  }
  return session;
}

inline std::vector<Eigen::VectorXd> positions(const Plan& p) {
  std::vector<Eigen::VectorXd> all;
  for (const PlannedPose& pose : p.poses) all.push_back(pose.position);
  return all;
}

/// Poses of the simulation that were not taken: random ones.
inline std::vector<Eigen::VectorXd> random_poses(const SimulatedSession& s, std::size_t from, std::size_t count) {
  std::vector<Eigen::VectorXd> all;
  for (std::size_t i = from; i < from + count; ++i) all.push_back(s.session.observations[i].position);
  return all;
}

inline Session first_of(const SimulatedSession& s, std::size_t count) {
  Session session = s.session;
  session.observations.resize(count);
  return session;
}

}  // namespace handsight::fixture
