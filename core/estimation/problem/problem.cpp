// SPDX-License-Identifier: Apache-2.0
#include "estimation/problem/problem.h"

#include <algorithm>

#include "chain/sighting.h"

namespace handsight {

void place_unseen(Problem& problem) {
  if (!problem.has_shape_prior()) return;
  std::vector<char> is_seen(static_cast<std::size_t>(problem.shape->piece_count()), 0);
  for (std::size_t m = 0; m < problem.marker_is_seen.size(); ++m)
    if (problem.marker_is_seen[m]) is_seen[static_cast<std::size_t>(problem.shape->piece(m))] = 1;
  for (std::size_t m = 0; m < problem.marker_is_seen.size(); ++m)
    problem.marker_is_seen[m] = is_seen[static_cast<std::size_t>(problem.shape->piece(m))];
}

Eigen::VectorXd effect_values(const Problem& problem) {
  Eigen::VectorXd values(problem.effect_count());
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const EffectColumn& c = problem.columns_of_effects[static_cast<std::size_t>(i)];
    values[i] = problem.terms[c.term].values[c.parameter];
  }
  return values;
}

void set_effect_values(Problem& problem, const Eigen::VectorXd& values) {
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const EffectColumn& c = problem.columns_of_effects[static_cast<std::size_t>(i)];
    problem.terms[c.term].values[c.parameter] = values[i];
  }
}

void set_effects(Problem& problem, const Eigen::VectorXd& values) {
  set_effect_values(problem, values);
  place_observations(problem);
}

void hold_effects(Problem& problem) {
  problem.columns_of_effects.clear();
  problem.cameras_by_effect.resize(0, 0);
  if (problem.robot_scale) problem.robot_scale->by_effect.resize(0);
  for (ProblemObservation& o : problem.observations) o.motion = EffectMotion{};
}

Problem as_points(const Problem& problem, int& left_out) {
  left_out = 0;
  if (!problem.rig) return problem;
  Problem points = problem;
  points.rig.reset();
  points.marker_is_seen.assign(points.marker_is_seen.size(), 0);
  for (ProblemObservation& observation : points.observations) {
    std::vector<Sighting> kept;
    observation.point_covariances.clear();
    for (const Sighting& s : observation.sightings) {
      const auto point = triangulate(*problem.rig, s);
      if (!point) {
        ++left_out;
        continue;
      }
      kept.push_back({.marker = s.marker, .point = point->point, .by = s.by});
      observation.point_covariances.push_back(point->covariance);
      points.marker_is_seen[static_cast<std::size_t>(s.marker)] = 1;
    }
    observation.sightings = std::move(kept);
  }
  std::erase_if(points.observations, [](const ProblemObservation& o) { return o.sightings.empty(); });
  place_unseen(points);
  return points;
}

}  // namespace handsight
