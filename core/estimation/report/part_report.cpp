// SPDX-License-Identifier: Apache-2.0
#include "estimation/report/part_report.h"

#include <algorithm>

#include "base/error.h"
#include "session/sample.h"

namespace handsight {
namespace {

int part_at(const Session& joined, const ProblemObservation& o) {
  return joined.observations[static_cast<std::size_t>(o.index)].part;
}

/// Coordinates in the part's own unit.
Residuals in_own_unit(Residuals r, const SessionPart& part) {
  r.squares *= part.residual_unit * part.residual_unit;
  return r;
}

std::vector<int> observations_of(const Session& joined, int part, bool others) {
  std::vector<int> list;
  for (std::size_t i = 0; i < joined.observations.size(); ++i)
    if ((joined.observations[i].part == part) != others) list.push_back(static_cast<int>(i));
  return list;
}

/// Can other parts tell the term's numbers? Not what belongs to a part, nor a joint that none of the others moves.
bool is_reported_elsewhere(const EffectTerm& term, const Chain& chain, int part) {
  const Effect& effect = term_effect(term);
  if (effect.scope == EffectScope::session) return true;
  if (!moves_one_joint(effect)) return false;
  return std::any_of(chain.parts.begin(), chain.parts.end(), [&](const Chain& other) {
    const std::vector<int> places = other.part == part ? std::vector<int>() : effect_places(effect, other);
    return std::find(places.begin(), places.end(), term.place) != places.end();
  });
}

/// The model with the robot as it was found elsewhere; what is each part's own is estimated.
FitOptions with_robot_of(const Fit& elsewhere, const FitOptions& options, int part) {
  FitOptions own = options;
  own.effects.clear();
  own.estimated.clear();
  own.start = estimate(elsewhere);
  const Chain& chain = elsewhere.problem.source->chain;
  for (const EffectTerm& term : list_terms(elsewhere))
    (is_reported_elsewhere(term, chain, part) ? own.effects : own.estimated).push_back(term);
  return own;
}

/// To a hundredth of what a residual shows.
FitOptions to_what_is_shown(const Fit& fit, FitOptions options) {
  options.least_gain = std::max(options.least_gain, 1e-2 * fit.residual_rms * fit.residual_rms);
  options.reuse_below = std::max(options.reuse_below, 1e-3);
  options.most_iterations = std::min(options.most_iterations, 40);
  options.on_iteration = nullptr;
  return options;
}

std::vector<Residuals> held_out_part(const Session& joined, const Fit& fit, const FitOptions& options, int part) {
  FitOptions of_others = to_what_is_shown(fit, options);
  of_others.start = estimate(fit);
  const Fit elsewhere = handsight::fit(take_part(joined, observations_of(joined, part, true)), of_others);
  const FitOptions own = with_robot_of(elsewhere, to_what_is_shown(fit, options), part);
  const Session alone = take_part(joined, observations_of(joined, part, false));
  std::vector<Residuals> held;
  for (auto& one : report(alone, handsight::fit(alone, own), own).held_out_residuals)
    if (one) held.push_back(std::move(*one));
  return held;
}

}  // namespace

std::vector<PartReport> part_reports(const Session& joined, const Fit& fit, const FitReport& reported) {
  if (joined.parts.empty()) return {};
  std::vector<PartReport> reports(joined.parts.size());
  const std::vector<FitPart> found = list_parts(joined, fit);
  std::vector<std::vector<Residuals>> fitted(reports.size()), held(reports.size());
  for (const Observation& o : joined.observations) ++reports[static_cast<std::size_t>(o.part)].observations;
  for (std::size_t i = 0; i < fit.problem.observations.size(); ++i) {
    const ProblemObservation& o = fit.problem.observations[i];
    const auto p = static_cast<std::size_t>(part_at(joined, o));
    const SessionPart& part = joined.parts[p];
    fitted[p].push_back(in_own_unit(compute_residuals(fit.problem, o, estimate(fit)), part));
    if (i < reported.held_out_residuals.size() && reported.held_out_residuals[i])
      held[p].push_back(in_own_unit(*reported.held_out_residuals[i], part));
    ++reports[p].used;
    ObservationReport one = reported.per_observation[i];
    one.id -= part.first_id;
    if (part.camera_count == 0)
      one.rms_pixel.reset();
    else if (one.rms_pixel)
      *one.rms_pixel *= part.residual_unit;
    reports[p].per_observation.push_back(one);
  }
  for (std::size_t p = 0; p < reports.size(); ++p) {
    reports[p].title = joined.parts[p].title;
    reports[p].has_cameras = joined.parts[p].camera_count > 0;
    reports[p].found = found[p];
    if (p < reported.held_out_sessions.size()) reports[p].held_out_session = reported.held_out_sessions[p];
    if (!fitted[p].empty()) reports[p].fitted = summary(fitted[p], reports[p].has_cameras);
    if (!held[p].empty()) reports[p].held_out = summary(held[p], reports[p].has_cameras);
  }
  return reports;
}

FitReport make_report(const PartReport& part) {
  FitReport r;
  r.observations = part.observations;
  r.used = part.used;
  r.fitted = part.fitted;
  r.held_out = part.held_out;
  r.per_observation = part.per_observation;
  return r;
}

void hold_out_sessions(const Session& joined, const Fit& fit, const FitOptions& options, FitReport& reported,
                       const std::function<bool()>& go_on) {
  if (joined.parts.empty()) return;
  std::vector<Residuals> all;
  reported.held_out_sessions.assign(joined.parts.size(), {});
  for (std::size_t p = 0; p < joined.parts.size(); ++p) {
    if (go_on && !go_on()) return;
    std::vector<Residuals> held;
    try {
      held = held_out_part(joined, fit, options, static_cast<int>(p));
    } catch (const InputError&) {
      continue;  // what is its own cannot be known from it alone
    }
    all.insert(all.end(), held.begin(), held.end());
    const SessionPart& part = joined.parts[p];
    for (Residuals& r : held) r = in_own_unit(std::move(r), part);
    if (!held.empty()) reported.held_out_sessions[p] = summary(held, part.camera_count > 0);
  }
  if (!all.empty()) reported.held_out_session = summary(all, joined.rig.has_value());
}

}  // namespace handsight
