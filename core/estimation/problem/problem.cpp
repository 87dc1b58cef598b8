// SPDX-License-Identifier: Apache-2.0
#include "estimation/problem/problem.h"

#include <algorithm>

#include "effects/own_effect.h"
#include "estimation/problem/robot_scale.h"
#include "session/by_time.h"

namespace handsight {
namespace {

/// Do formulas of these terms, or of effects that may become terms, read what `flag` stands for?
bool reads(bool Effect::*flag, const std::vector<EffectTerm>& terms, const OwnEffects& own) {
  return std::any_of(terms.begin(), terms.end(), [&](const EffectTerm& t) { return t.own && (*t.own).*flag; }) ||
         std::any_of(own.begin(), own.end(), [&](const auto& effect) { return (*effect).*flag; });
}

/// A marker has a place as soon as a point of its piece is seen: the shape says where it then is.
void place_unseen(Problem& problem) {
  if (!problem.has_shape_prior()) return;
  std::vector<char> is_seen(static_cast<std::size_t>(problem.shape->piece_count()), 0);
  for (std::size_t m = 0; m < problem.marker_is_seen.size(); ++m)
    if (problem.marker_is_seen[m]) is_seen[static_cast<std::size_t>(problem.shape->piece(m))] = 1;
  for (std::size_t m = 0; m < problem.marker_is_seen.size(); ++m)
    problem.marker_is_seen[m] = is_seen[static_cast<std::size_t>(problem.shape->piece(m))];
}

void require_bearable(const Session& session) {
  constexpr int most = 1024;
  if (session.marker_count > most)
    throw InputError(
        fmt::format("{}: a fit can bear {} points, and the target has {}; use one with fewer squares or "
                    "tags, or name fewer ids.",
                    session.file.filename().string(), most, session.marker_count));
}

}  // namespace

Problem make_problem(const Session& session, const Chain& chain, const std::vector<EffectTerm>& held,
                     const std::vector<EffectTerm>& estimated) {
  require_bearable(session);
  Problem problem;
  problem.rig = chain.rig;
  problem.shape = session.shape;
  problem.marker_count = chain.marker_count;
  problem.mount_is_estimated = session.mount.estimate;
  problem.marker_is_seen.assign(static_cast<std::size_t>(chain.marker_count), 0);
  problem.terms = held;
  for (const EffectTerm& term : estimated) {
    const Effect& effect = effect_of(term);
    for (std::size_t p = 0; p < effect.parameters.size(); ++p)
      if (is_free(effect, term, p))
        problem.columns_of_effects.push_back({problem.terms.size(), p, plausible_size(effect.parameters[p], chain)});
    problem.terms.push_back(term);
  }
  auto source = std::make_shared<ProblemSource>();
  source->chain = chain;
  source->circumstances = circumstances_of(session, source->chain);
  source->own_effects = own_effects_of(session, source->chain);
  const bool torques = reads(&Effect::reads_torque, problem.terms, source->own_effects);
  const bool places = reads(&Effect::reads_place, problem.terms, source->own_effects);
  for (Circumstances& c : source->circumstances) {
    if (torques) c.torque = nominal_torques(source->chain, c.sensor);
    if (places) c.tcp = nominal_tcp(source->chain, c.sensor);
  }
  problem.source = source;
  if (measures_no_length(session, chain)) problem.robot_scale = described_scale(problem);

  const double usual = usual_sigma(session);
  for (const int index : by_time(session)) {
    const Observation& observation = session.observations[static_cast<std::size_t>(index)];
    if (!is_used(observation)) continue;
    ProblemObservation& o = problem.observations.emplace_back();
    o.index = index;
    o.sightings = observation.sightings;
    for (Sighting& s : o.sightings) s.usual_sigma = usual;
    for (const Sighting& s : observation.sightings) problem.marker_is_seen[static_cast<std::size_t>(s.marker)] = 1;
  }
  place_unseen(problem);
  place_observations(problem);
  return problem;
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
