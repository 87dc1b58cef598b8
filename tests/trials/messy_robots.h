// SPDX-License-Identifier: Apache-2.0
// Robots as they are: several effects at once, masses a little wrong, joints that do not repeat, and a shift of the
// hand that no catalogue has.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <set>
#include <string>

#include "estimation/fit/fit.h"
#include "fixtures/trial_sessions.h"

namespace handsight::trials {

inline constexpr int measured = 100, fresh = 200;
inline constexpr double mass_error = 0.12, repeatability = 1e-4;  // relative; rad

/// What is true and hidden.
struct Messy {
  Session session;  // as measured: the nominal robot
  Robot true_robot;
  std::vector<EffectTerm> effects;
  std::optional<EffectTerm> shift;
  Rigid tcp_from_body;
  std::vector<Eigen::VectorXd> fresh_poses;
};

/// Three to five effects, 0.15 to 1 of the usual size.
inline std::vector<EffectTerm> hidden_effects(const Session& like, std::mt19937_64& random) {
  static const std::set<std::string> left_out{"body_slip", "marker_slip", "mount_slip"};
  const Chain chain = make_chain(like);
  const std::size_t count = 3 + random() % 3;
  std::vector<EffectTerm> all;
  std::set<std::string> ids;
  std::uniform_real_distribution<double> uniform(0, 1);
  while (ids.size() < count) {
    const Effect& e = catalogue()[random() % catalogue().size()];
    if (left_out.count(e.id) || ids.count(e.id)) continue;
    std::vector<EffectTerm> terms = random_terms(e, chain, random);
    if (terms.empty()) continue;
    // random_terms draws 0.3 to 3 of the usual size; here 0.15 to 1.
    const double size = 0.15 * std::pow(1 / 0.15, uniform(random)) / (0.3 * std::pow(10.0, 0.5));
    for (EffectTerm& t : terms)
      for (std::size_t p = 0; p < t.values.size(); ++p)
        if (!e.parameters[p].is_choice) t.values[p] *= size;
    SimulationOptions alone = simulation(1);
    alone.observations = measured;
    alone.effects = terms;
    if (like.robot.name == "random_robot") alone.farthest = 3;
    if (noncentrality_of(like, alone) < 50) continue;  // what these poses do not show is nobody's to find
    ids.insert(e.id);
    all.insert(all.end(), terms.begin(), terms.end());
  }
  return all;
}

inline Messy messy_session(int robot, std::uint64_t seed, double size_mm) {
  std::mt19937_64 random(seed * 9176 + 31 * static_cast<unsigned>(robot) + static_cast<unsigned>(1000 * size_mm));
  std::normal_distribution<double> normal;
  const Session like = robot_session(robot, seed);
  Messy m;
  Session real = like;
  for (Link& link : real.robot.links) link.mass *= std::max(0.3, 1 + mass_error * normal(random));
  m.true_robot = real.robot;
  m.effects = hidden_effects(like, random);
  m.shift = hidden_shift(like, size_mm, random);
  SimulationOptions o = simulation(seed + 40000, robot);
  o.observations = measured;
  o.effects = m.effects;
  if (m.shift) o.effects.push_back(*m.shift);
  SimulatedSession s = simulate_session(real, o);
  m.session = s.session;
  m.session.robot = like.robot;
  for (Observation& observation : m.session.observations)
    for (Eigen::Index j = 0; j < observation.position.size(); ++j)
      observation.position[j] += repeatability * normal(random);
  const std::vector<std::optional<Vector3>> known(s.markers_in_tcp.begin(), s.markers_in_tcp.end());
  m.tcp_from_body = body_frame(choose_sides(known), s.markers_in_tcp).tcp_from_body;
  SimulationOptions later = o;
  later.seed = seed + 70000;
  later.observations = fresh;
  for (const Observation& observation : simulate_session(real, later).session.observations)
    m.fresh_poses.push_back(observation.position);
  return m;
}

inline Rigid hand_at(const Chain& chain, const Eigen::VectorXd& pose, const std::vector<EffectTerm>& terms) {
  const ObservationState c = states_at(chain, pose);
  return observed_ends(c, moved_sites(c, terms)).ends.root_from_tcp;
}

/// Where a fit puts the body's origin in the TCP frame at a pose, beside what its terms move.
using PointOfHand = std::function<Vector3(const Eigen::VectorXd& pose)>;

/// Mean distance (mm) of the body's true origin in fresh poses from where the fit puts it.
inline double error_on_fresh(const Messy& m, const Fit& f, const PointOfHand& point) {
  Session real = m.session;
  real.robot = m.true_robot;
  const Chain truth = make_chain(real), model = make_chain(m.session);
  std::vector<EffectTerm> terms = m.effects;
  if (m.shift) terms.push_back(*m.shift);
  double sum = 0;
  for (const Eigen::VectorXd& pose : m.fresh_poses)
    sum +=
        (hand_at(truth, pose, terms) * m.tcp_from_body.translation - hand_at(model, pose, list_terms(f)) * point(pose))
            .norm();
  return 1e3 * sum / static_cast<double>(m.fresh_poses.size());
}

inline double error_on_fresh(const Messy& m, const Fit& f) {
  return error_on_fresh(m, f, [&](const Eigen::VectorXd&) { return f.tcp_from_body.translation; });
}

}  // namespace handsight::trials
