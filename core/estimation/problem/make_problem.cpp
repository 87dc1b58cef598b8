// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "base/error.h"
#include "effects/own_effect.h"
#include "estimation/problem/problem.h"
#include "estimation/problem/robot_scale.h"
#include "session/by_time.h"
#include "session/fixtures/fixture_kind.h"

namespace handsight {
namespace {

/// Do formulas of these terms, or of effects that may become terms, read what `flag` stands for?
bool reads(bool Effect::*flag, const std::vector<EffectTerm>& terms, const OwnEffects& own) {
  return std::any_of(terms.begin(), terms.end(), [&](const EffectTerm& t) { return t.own && (*t.own).*flag; }) ||
         std::any_of(own.begin(), own.end(), [&](const auto& effect) { return (*effect).*flag; });
}

void require_bearable(const Session& session) {
  constexpr int most = 1024;
  if (session.marker_count > most)
    throw InputError(
        message("{}: a fit can bear {} points, and the target has {}; use one with fewer squares or "
                "tags, or name fewer ids.",
                session.file.filename().string(), most, session.marker_count));
}

void require_one_link(const Session& session, const KnownDistance& d, const Chain& chain) {
  const auto of = static_cast<std::size_t>(d.of), from = static_cast<std::size_t>(d.from);
  const auto link = [&](int fixture) {
    return chain.parts[static_cast<std::size_t>(&part_of_fixture(session, fixture) - session.parts.data())].mount_link;
  };
  if (link(d.of) == link(d.from)) return;
  throw InputError(
      message("{}: <apart> names {} and {}, which stand on different links; their distance is not one "
              "number.",
              session.file.filename().string(), session.fixtures[of].id, session.fixtures[from].id));
}

/// Of what has a height that of three places 0.3 m apart, of an axis two places of it, of an origin the three numbers.
void add_known_place(const Session& session, int fixture, std::vector<MountPlace>& places) {
  const Fixture& f = session.fixtures[static_cast<std::size_t>(fixture)];
  if (!f.place_sigma) return;
  constexpr double apart = 0.3;  // m
  const int number = part_of_fixture(session, fixture).mount;
  const Rigid& frame = find_mount(session, number).mount_from_sensor;
  const auto add = [&](const Vector3& in_frame, const Vector3& along) {
    places.push_back({number, frame * in_frame, along, *f.place_sigma});
  };
  const Vector3 x = Vector3::UnitX(), y = Vector3::UnitY(), z = Vector3::UnitZ(), origin = Vector3::Zero();
  switch (f.kind->place) {
    case FixturePlace::height:
      for (const Vector3& at : {origin, Vector3(apart * x), Vector3(apart * y)}) add(at, z);
      return;
    case FixturePlace::axis:
      for (const Vector3& at : {origin, Vector3(apart * z)})
        for (const Vector3& along : {x, y}) add(at, along);
      return;
    case FixturePlace::origin:
      for (const Vector3& along : {x, y, z}) add(origin, along);
      return;
  }
}

/// A target's scale is by the places where a pose sensor saw it: terms of a fit of other observations know only theirs.
void take_own_places(const Session& session, const OwnEffects& own, std::vector<EffectTerm>& terms) {
  if (!session.pose_sensor) return;
  for (EffectTerm& term : terms)
    for (const auto& effect : own)
      if (term.own && term.id == "target_scale" && effect->id == term.id) term.own = effect;
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
  for (const Mount& mount : session.other_mounts) problem.other_mounts_estimated.push_back(mount.estimate);
  for (const KnownDistance& d : session.distances) {
    require_one_link(session, d, chain);
    problem.mount_distances.push_back(
        {part_of_fixture(session, d.of).mount, part_of_fixture(session, d.from).mount, d.by, d.sigma});
  }
  for (std::size_t f = 0; f < session.fixtures.size(); ++f)
    add_known_place(session, static_cast<int>(f), problem.mount_places);
  problem.marker_is_seen.assign(static_cast<std::size_t>(chain.marker_count), 0);
  problem.terms = held;
  for (const EffectTerm& term : estimated) {
    const Effect& effect = term_effect(term);
    for (std::size_t p = 0; p < effect.parameters.size(); ++p)
      if (is_free(effect, term, p))
        problem.columns_of_effects.push_back(
            {problem.terms.size(), p, term.size * prior_sigma(effect.parameters[p], chain)});
    problem.terms.push_back(term);
  }
  auto source = std::make_shared<ProblemSource>();
  source->chain = chain;
  source->states = observation_states(session, source->chain);
  source->own_effects = list_own_effects(session, source->chain);
  take_own_places(session, source->own_effects, problem.terms);
  const bool torques = reads(&Effect::reads_torque, problem.terms, source->own_effects);
  const bool places = reads(&Effect::reads_place, problem.terms, source->own_effects);
  for (ObservationState& c : source->states) {
    if (torques) c.torque = nominal_torques(*c.chain, c.sensor);
    if (places) c.tcp = nominal_tcp(*c.chain, c.sensor);
  }
  problem.source = source;
  if (measures_no_length(session, chain)) problem.robot_scale = described_scale(problem);

  const double usual = usual_sigma(session);
  for (const int index : by_time(session)) {
    const Observation& observation = session.observations[static_cast<std::size_t>(index)];
    if (!is_used(observation)) continue;
    ProblemObservation& o = problem.observations.emplace_back();
    o.index = index;
    o.mount = source->states[static_cast<std::size_t>(index)].chain->mount;
    o.sightings = observation.sightings;
    for (Sighting& s : o.sightings) s.usual_sigma = usual;
    for (const Sighting& s : observation.sightings) problem.marker_is_seen[static_cast<std::size_t>(s.marker)] = 1;
  }
  place_unseen(problem);
  place_observations(problem);
  return problem;
}

}  // namespace handsight
