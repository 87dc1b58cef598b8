// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/selection/improvement.h"

#include <set>
#include <string>
#include <utility>

#include "diagnosis/selection/choosing.h"
#include "diagnosis/selection/conclusion.h"
#include "diagnosis/selection/elsewhere.h"
#include "diagnosis/selection/regrowing.h"
#include "diagnosis/verdict/sampled.h"
#include "estimation/fit/sure_fit.h"
#include "estimation/report/fit_report.h"

namespace handsight {
namespace {

/// What is missing was asked of fits in which every pixel counts alike, so that it does not pass for the robot's
/// error from pose to pose. Where such an error is what is left, the answer is that of a fit that weighs it, as fit()
/// does.
void weigh_the_robots_error(const Session& session, Improvement& m) {
  Diagnosis& d = m.last;
  if (!session.rig || has_no_answer(d.model.fit)) return;
  FitOptions o = d.model_options;
  o.smallest_step = FitOptions{}.smallest_step;
  Fit weighed = fit(d.model.session, o);
  if (!weighed.converged() || !weighed.problem.flange_error.is_any()) return;
  d.model.fit = std::move(weighed);
  d.report = report(d.model.session, d.model.fit, o);
  set_errors_elsewhere(d);
  const ImprovementStep now = find_step(d);
  ImprovementStep& last = m.steps.back();
  m.unweighed = last;
  last.fitted = now.fitted;
  last.held_out = now.held_out;
  last.held_out_region = now.held_out_region;
  last.held_out_session = now.held_out_session;
}

struct Improved {
  Improvement m;
  int models = 0;  // of the walk alone, without other ends
};

Improved improved(const Session& session, const ImprovementOptions& options, bool with_other_ends) {
  ModelWalk walk(session, options);
  walk.begin();
  const std::optional<double> excess = walk.so_far().last.excess;
  walk.run();
  const int models = walk.so_far().models;
  if (with_other_ends && !walk.so_far().stopped) regrow(session, options, walk);
  walk.run_beside_background();
  Improvement& m = walk.so_far();
  if (m.stopped) return {std::move(m), models};
  m.inclusion_probabilities = walk.certain();
  conclude(excess, walk.refused_last(), m);
  weigh_the_robots_error(session, m);
  return {std::move(m), models};
}

/// Other ends are not sought there: folds would take as long again, each.
void try_choosing(const Session& session, const ImprovementOptions& options, int models, Improvement& m) {
  const bool has_chosen =
      options.with_choosing && m.steps.size() > 1 && !m.stopped && m.last.verdict != Verdict::too_few_observations;
  const Fit& chosen = m.last.model.fit;
  if (!has_chosen || !session.parts.empty() || has_no_answer(chosen) || !are_few_to_choose_by(chosen) ||
      !is_cheap_to_choose(chosen, models))
    return;
  ImprovementOptions quiet = options;
  quiet.on_step = {};
  quiet.on_iteration = {};
  quiet.on_progress = [&options](double) { return !options.on_progress || options.on_progress(0.99); };
  m.held_out_choosing = error_with_choosing(session, chosen, [&](const Session& part) -> std::optional<Fit> {
    Improvement without = improved(part, quiet, false).m;
    if (without.stopped) return std::nullopt;
    return std::move(without.last.model.fit);
  });
}

std::set<std::pair<std::string, int>> places_of(const Diagnosis& model) {
  std::set<std::pair<std::string, int>> places;
  for (const EffectTerm& t : model.model_options.estimated) places.emplace(t.id, t.place);
  return places;
}

}  // namespace

Improvement improve(const Session& session, const ImprovementOptions& options) {
  if (const auto sample = sample_to_judge(session)) {
    Improvement m = improve(sample->session, options);
    check_on_the_others(session, *sample, m.last);
    return m;
  }
  Improved i = improved(session, options, true);
  try_choosing(session, options, i.models, i.m);
  return std::move(i.m);
}

ModelChange improve_on(const Session& session, const ImprovementOptions& options, const Diagnosis& model) {
  if (const auto sample = sample_to_judge(session)) {
    ModelChange change = improve_on(sample->session, options, model);
    if (change.model) check_on_the_others(session, *sample, *change.model);
    return change;
  }
  ImprovementOptions of_walk = options;
  if (options.is_thorough)  // most of the time goes by after it
    of_walk.on_progress = [&options](double) { return !options.on_progress || options.on_progress(0); };
  ModelWalk walk(session, of_walk);
  walk.begin_at(model);
  walk.run();
  if (!walk.so_far().stopped) regrow(session, options, walk);
  walk.run_beside_background();
  Improvement& m = walk.so_far();
  ModelChange change;
  change.models = m.models;
  change.refused = std::move(m.refused);
  change.stopped = m.stopped;
  if (places_of(m.last) == places_of(model)) return change;
  change.steps.assign(m.steps.begin() + 1, m.steps.end());
  change.model = std::move(m.last);
  return change;
}

}  // namespace handsight
