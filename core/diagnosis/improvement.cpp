// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/improvement.h"

#include <algorithm>

#include "diagnosis/exchange.h"
#include "diagnosis/refitting.h"

namespace handsight {
namespace {

/// The number by which models are compared: px, or m with a tracker.
double held_out(const ErrorSummary& e) { return e.rms_pixel ? *e.rms_pixel : e.rms_m.value_or(0); }

Diagnosis diagnosed_from(const Session& session, const ImprovementOptions& options,
                         const std::vector<EffectTerm>& estimated, const std::optional<Unknowns>& start) {
  DiagnosisOptions o;
  o.effects = options.effects;
  o.estimated = estimated;
  o.start = start;
  o.on_progress = options.on_progress;
  o.on_iteration = options.on_iteration;
  return diagnose(session, o);
}

/// The terms of one effect that stand together, from `first` on, end there.
std::size_t end_of_group(const std::vector<EffectTerm>& terms, std::size_t first) {
  std::size_t last = first + 1;
  while (last < terms.size() && terms[last].id == terms[first].id) ++last;
  return last;
}

/// What the squares would grow by, in units of the noise and to first order, if the terms from `first` to `last` of
/// the estimated ones were 0 and all else followed.
double squares_without(const Diagnosis& d, std::size_t first, std::size_t last, double noise) {
  const Problem& problem = d.model.fit.problem;
  const std::size_t held = d.model_options.effects.size();
  std::vector<Eigen::Index> theirs, others;
  for (Eigen::Index c = 0; c < problem.columns(); ++c) {
    const Eigen::Index effect = c - problem.effect_column();
    const std::size_t term = effect < 0 ? 0 : problem.columns_of_effects[static_cast<std::size_t>(effect)].term - held;
    (effect >= 0 && term >= first && term < last ? theirs : others).push_back(c);
  }
  const Eigen::MatrixXd& h = d.model.fit.solution.normal.information;
  const Eigen::VectorXd all = [&] {
    Eigen::VectorXd values = Eigen::VectorXd::Zero(problem.columns());
    values.tail(problem.effect_count()) = estimate(d.model.fit).effects;
    return values;
  }();
  const Eigen::VectorXd value = all(theirs);
  const Eigen::VectorXd shared = h(others, theirs) * value;
  const double squares = value.dot(h(theirs, theirs) * value) - shared.dot(pseudo_inverse(h(others, others)) * shared);
  return squares / (noise * noise);
}

/// Takes the terms from `first` to `last` out of the estimated ones where they are not worth their parameters.
bool drop(const Session& session, const ImprovementOptions& options, std::size_t first, std::size_t last,
          ModelChange& change) {
  const Diagnosis& d = *change.model;
  const Fit& with = d.model.fit;
  const auto begin = d.model_options.estimated.begin();
  const std::vector<EffectTerm> dropped(begin + static_cast<std::ptrdiff_t>(first),
                                        begin + static_cast<std::ptrdiff_t>(last));
  const Weighing by = weighing(with);
  // To first order it cannot be said by how much a large effect is needed, but that it is.
  if (squares_without(d, first, last, by.noise) > 10 * d.threshold + 100) return false;
  FitOptions o = d.model_options;
  set_quick(by, o);
  o.estimated.erase(o.estimated.begin() + static_cast<std::ptrdiff_t>(first),
                    o.estimated.begin() + static_cast<std::ptrdiff_t>(last));
  const Fit without = fit(d.model.session, o);
  const double gained = fit_evidence(with, with.problem.effect_count(), by).ln_evidence -
                        fit_evidence(without, without.problem.effect_count(), by).ln_evidence;
  if (gained >= d.threshold) return false;
  Diagnosis next = diagnosed_from(session, options, o.estimated, estimate(without));
  change.stopped = next.stopped;
  if (next.stopped || held_out(next.report.held_out) > 1.001 * held_out(d.report.held_out)) return false;
  change.steps.push_back(step_of(next));
  change.steps.back().removed = dropped.front().id;
  change.steps.back().where = places_of(dropped, session);
  change.steps.back().terms = dropped;
  change.model = std::move(next);
  return true;
}

/// Everything added before the last step must still be worth its parameters.
void drop_what_is_no_longer_needed(const Session& session, const ImprovementOptions& options, ModelChange& change) {
  for (std::size_t first = options.estimated.size(); !change.stopped;) {
    const std::vector<EffectTerm>& terms = change.model->model_options.estimated;
    if (first >= terms.size()) return;
    const std::size_t last = end_of_group(terms, first);
    if (last == terms.size() || !drop(session, options, first, last, change)) first = last;
  }
}

/// Names that stood in for another are exchanged; those that were added last stay.
void exchange_names(const Session& session, const ImprovementOptions& options, ModelChange& change) {
  const auto goes_on = [&] { return !options.on_progress || options.on_progress(0.97); };
  for (std::size_t first = options.estimated.size(); !change.stopped;) {
    const std::vector<EffectTerm>& terms = change.model->model_options.estimated;
    if (first >= terms.size()) return;
    const std::size_t last = end_of_group(terms, first);
    if (last == terms.size()) return;
    const std::vector<EffectTerm> removed(terms.begin() + static_cast<std::ptrdiff_t>(first),
                                          terms.begin() + static_cast<std::ptrdiff_t>(last));
    const auto exchange = better_name(*change.model, first, last, goes_on);
    change.stopped = !goes_on();
    if (exchange && !change.stopped) {
      Diagnosis next = diagnosed_from(session, options, exchange->options.estimated, exchange->options.start);
      change.stopped = next.stopped;
      if (!next.stopped && held_out(next.report.held_out) <= 1.001 * held_out(change.model->report.held_out)) {
        change.steps.push_back(step_of(next));
        change.steps.back().added = exchange->id;
        change.steps.back().removed = removed.front().id;
        change.steps.back().where = places_of(exchange->terms, session);
        change.steps.back().terms = exchange->terms;
        change.model = std::move(next);
        continue;  // the next group has moved here; the new name stands last
      }
    }
    first = last;
  }
}

}  // namespace

ImprovementStep step_of(const Diagnosis& model) {
  ImprovementStep s;
  s.fitted = model.report.fitted;
  s.held_out = model.report.held_out;
  s.noise = model.noise;
  return s;
}

bool is_outdone(const Diagnosis& d) {
  return !d.candidates.empty() && d.candidates.front().unnamed && d.candidates.front().ln_bayes_factor >= d.threshold;
}

Diagnosis diagnosed(const Session& session, const ImprovementOptions& options) {
  return diagnosed_from(session, options, options.estimated, {});
}

ModelChange add_candidate(const Session& session, const ImprovementOptions& options, const Diagnosis& model,
                          const DiagnosisCandidate& candidate) {
  ModelChange change;
  FitOptions from = candidate.full_fit.value_or(model.model_options);
  if (!candidate.full_fit) from.estimated.insert(from.estimated.end(), candidate.terms.begin(), candidate.terms.end());
  Diagnosis next = diagnosed_from(session, options, from.estimated, from.start);
  change.stopped = next.stopped;
  if (next.stopped) return change;
  if (held_out(next.report.held_out) >= held_out(model.report.held_out)) {
    change.refused.push_back({candidate.id, candidate.where, "the held-out error does not fall"});
    return change;
  }
  change.steps.push_back(step_of(next));
  change.steps.back().added = candidate.id;
  change.steps.back().where = candidate.where;
  change.steps.back().terms = candidate.terms;
  change.model = std::move(next);
  drop_what_is_no_longer_needed(session, options, change);
  if (!change.stopped) exchange_names(session, options, change);
  if (change.stopped) change.model.reset();
  return change;
}

ModelChange add_best(const Session& session, const ImprovementOptions& options, const Diagnosis& model) {
  ModelChange all;
  if (model.verdict == Verdict::too_few_observations || model.verdict == Verdict::adequate) return all;
  for (const DiagnosisCandidate& c : model.candidates) {
    if (c.unnamed) continue;
    if (c.ln_bayes_factor < model.threshold) break;
    ModelChange one = add_candidate(session, options, model, c);
    all.refused.insert(all.refused.end(), one.refused.begin(), one.refused.end());
    all.model = std::move(one.model);
    all.steps = std::move(one.steps);
    all.stopped = one.stopped;
    if (all.stopped || all.model) break;
  }
  return all;
}

Improvement improve(const Session& session, const ImprovementOptions& options) {
  Improvement m;
  m.last = diagnosed(session, options);
  m.steps = {step_of(m.last)};
  m.stopped = m.last.stopped;
  Improvement settled = m;  // the last model that no unnamed curve outdoes
  while (!m.stopped && static_cast<int>(m.steps.size()) <= options.most_steps) {
    if (options.on_step && !options.on_step(m.steps.back())) {
      m.stopped = true;
      break;
    }
    ModelChange change = add_best(session, options, m.last);
    m.refused.insert(m.refused.end(), change.refused.begin(), change.refused.end());
    m.stopped = change.stopped;
    if (!change.model) break;
    m.steps.insert(m.steps.end(), change.steps.begin(), change.steps.end());
    m.last = std::move(*change.model);
    if (!is_outdone(m.last)) settled = m;
  }
  if (!is_outdone(m.last) || m.stopped) return m;
  // Names that leave an unnamed curve on top have not explained anything.
  for (std::size_t i = settled.steps.size(); i < m.steps.size(); ++i)
    m.refused.push_back({m.steps[i].added, m.steps[i].where,
                         "with it an unnamed curve still explains more than anything that has a name"});
  m.steps = std::move(settled.steps);
  m.last = std::move(settled.last);
  return m;
}

}  // namespace handsight
