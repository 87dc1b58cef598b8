// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/improvement.h"

#include <algorithm>

#include "diagnosis/refitting.h"

namespace handsight {
namespace {

/// The number by which models are compared: px, or m with a tracker.
double held_out(const ErrorSummary& e) { return e.rms_pixel ? *e.rms_pixel : e.rms_m.value_or(0); }

/// A model and what was said of it.
struct State {
  std::vector<EffectTerm> estimated;
  std::vector<ImprovementStep> steps;
  Diagnosis diagnosis;
};

class Improver {
 public:
  Improver(const Session& session, const ImprovementOptions& options) : session_(session), options_(options) {}

  Improvement run() {
    State state;
    state.estimated = options_.estimated;
    state.diagnosis = diagnosed(state.estimated);
    state.steps.push_back(step_of(state.diagnosis));
    State settled = state;  // the last model that no unnamed curve outdoes
    while (!stopped_ && static_cast<int>(state.steps.size()) <= options_.most_steps) {
      if (options_.on_step && !options_.on_step(state.steps.back())) {
        stopped_ = true;
        break;
      }
      std::optional<State> next = one_more(state);
      if (!next) break;
      state = std::move(*next);
      drop_what_is_no_longer_needed(state);
      if (!is_outdone(state.diagnosis)) settled = state;
    }
    // Names that leave an unnamed curve on top have not explained anything.
    if (is_outdone(state.diagnosis)) {
      for (std::size_t i = settled.steps.size(); i < state.steps.size(); ++i)
        refused_.push_back({state.steps[i].added, state.steps[i].where,
                            "with it an unnamed curve still explains more than anything that has a name"});
      state = std::move(settled);
    }
    return {std::move(state.steps), std::move(refused_), std::move(state.diagnosis), stopped_};
  }

 private:
  Diagnosis diagnosed(const std::vector<EffectTerm>& estimated, const std::optional<Unknowns>& start = {}) {
    DiagnosisOptions o;
    o.effects = options_.effects;
    o.estimated = estimated;
    o.start = start;
    o.on_progress = options_.on_progress;
    Diagnosis d = diagnose(session_, o);
    stopped_ = stopped_ || d.stopped;
    return d;
  }

  static ImprovementStep step_of(const Diagnosis& d) {
    ImprovementStep s;
    s.fitted = d.report.fitted;
    s.held_out = d.report.held_out;
    s.noise = d.noise;
    return s;
  }

  /// Does an unnamed curve pass and lead?
  static bool is_outdone(const Diagnosis& d) {
    return !d.candidates.empty() && d.candidates.front().unnamed && d.candidates.front().ln_bayes_factor >= d.threshold;
  }

  std::optional<State> one_more(const State& state) {
    const Diagnosis& d = state.diagnosis;
    if (d.verdict == Verdict::too_few_observations || d.verdict == Verdict::adequate) return std::nullopt;
    for (const DiagnosisCandidate& c : d.candidates) {
      if (c.unnamed) continue;
      if (c.ln_bayes_factor < d.threshold || stopped_) return std::nullopt;
      State next = state;
      next.estimated = d.model_options.estimated;
      next.estimated.insert(next.estimated.end(), c.terms.begin(), c.terms.end());
      next.diagnosis = diagnosed(next.estimated, estimate(d.model.fit));
      if (stopped_) return std::nullopt;
      next.estimated = next.diagnosis.model_options.estimated;
      if (held_out(next.diagnosis.report.held_out) < held_out(d.report.held_out)) {
        next.steps.push_back(step_of(next.diagnosis));
        next.steps.back().added = c.id;
        next.steps.back().where = c.where;
        next.steps.back().terms = c.terms;
        return next;
      }
      refused_.push_back({c.id, c.where, "the held-out error does not fall"});
    }
    return std::nullopt;
  }

  /// Everything added before the last step must still be worth its parameters.
  void drop_what_is_no_longer_needed(State& state) {
    const std::size_t given = options_.estimated.size();
    for (std::size_t first = given; first < state.estimated.size() && !stopped_;) {
      std::size_t last = first + 1;  // the terms of one effect that stand together
      while (last < state.estimated.size() && state.estimated[last].id == state.estimated[first].id) ++last;
      if (last == state.estimated.size() || !drop(state, first, last)) first = last;
    }
  }

  bool drop(State& state, std::size_t first, std::size_t last) {
    const Diagnosis& d = state.diagnosis;
    const Fit& with = d.model.fit;
    std::vector<EffectTerm> rest = state.estimated;
    const std::vector<EffectTerm> dropped(rest.begin() + static_cast<std::ptrdiff_t>(first),
                                          rest.begin() + static_cast<std::ptrdiff_t>(last));
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(first), rest.begin() + static_cast<std::ptrdiff_t>(last));
    FitOptions o = d.model_options;
    o.estimated = rest;
    const Fit without = fit(d.model.session, o);
    const double noise = with.noise_estimate ? with.noise_estimate->sigma : with.noise.value_or(with.residual_rms);
    const NoiseKnowledge knowledge{with.noise.has_value(), static_cast<double>(std::max(with.rows - with.unknowns, 1))};
    const double gained = fit_evidence(with, with.problem.effect_count(), noise, knowledge).ln_evidence -
                          fit_evidence(without, without.problem.effect_count(), noise, knowledge).ln_evidence;
    if (gained >= d.threshold) return false;
    State next = state;
    next.diagnosis = diagnosed(rest, estimate(without));
    if (stopped_ || held_out(next.diagnosis.report.held_out) > 1.001 * held_out(d.report.held_out)) return false;
    next.estimated = next.diagnosis.model_options.estimated;
    next.steps.push_back(step_of(next.diagnosis));
    next.steps.back().removed = dropped.front().id;
    next.steps.back().where = places_of(dropped, session_);
    next.steps.back().terms = dropped;
    state = std::move(next);
    return true;
  }

  const Session& session_;
  const ImprovementOptions& options_;
  std::vector<RefusedStep> refused_;
  bool stopped_ = false;
};

}  // namespace

Improvement improve(const Session& session, const ImprovementOptions& options) {
  return Improver(session, options).run();
}

}  // namespace handsight
