// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/verdict/diagnosis.h"

#include <algorithm>
#include <cmath>

#include "diagnosis/evidence/lack_of_fit.h"
#include "diagnosis/evidence/repeatability_levels.h"
#include "diagnosis/evidence/threshold.h"
#include "diagnosis/ranking/curves.h"
#include "diagnosis/ranking/outlier_rejection.h"
#include "diagnosis/verdict/candidate_report.h"
#include "diagnosis/verdict/explanation.h"
#include "diagnosis/verdict/finding.h"
#include "diagnosis/verdict/full_fits.h"
#include "diagnosis/verdict/judging.h"
#include "diagnosis/verdict/rare_causes.h"
#include "diagnosis/verdict/robot_check.h"
#include "diagnosis/verdict/sampled.h"
#include "effects/target_effects.h"

namespace handsight {
namespace {

constexpr double same_term = 0.98;                 // overlap of two effects' signals on these poses
constexpr double ln_million = 13.815510557964274;  // odds beyond which no overlap makes two causes one
constexpr double significant_pattern = 1e-3;
constexpr std::size_t most_patterns = 40;
constexpr double least_seen = 30;  // chi-squared of a prior sigma that poses must show
constexpr double least_visible_rival = 1;
constexpr double near_start = 1e-4;  // m, rad: a fit that begins at its own answer need not derive again

class Work {
 public:
  Work(const Session& session, const DiagnosisOptions& options) : session_(session), options_(options) {}

  Diagnosis run() {
    fit_the_model();
    if (stopped_) return stopped();
    if (options_.only_model && !has_too_few()) return std::move(d_);
    return find_what_is_missing();
  }

  /// Of a model that has been fitted before.
  Diagnosis go_on(Diagnosis model) {
    d_ = std::move(model);
    if (d_.threshold > 0) known_threshold_ = d_.threshold;
    return find_what_is_missing();
  }

  double threshold(const Diagnosis& model) {
    d_.model = model.model;
    d_.model_options = model.model_options;
    linearise();
    double best = -1e300;
    for (const Repeatability& repeatability : repeatability_levels(search_.model, search_.noise_model.knowledge)) {
      const double evidence = ln_evidence_of_base(search_.model, repeatability, search_.noise_model.knowledge);
      if (evidence > best) d_.repeatability = repeatability;
      best = std::max(best, evidence);
    }
    set_threshold();
    return d_.threshold;
  }

 private:
  bool has_too_few() const {
    const Fit& f = d_.model.fit;
    return f.problem.observations.size() < options_.fewest || f.rows - f.unknowns < 2 * f.unknowns;
  }

  Diagnosis find_what_is_missing() {
    const Fit& f = d_.model.fit;
    if (has_too_few()) {
      d_.verdict = Verdict::too_few_observations;
      d_.reason = too_few_text(static_cast<int>(f.problem.observations.size()), f.rows - f.unknowns, f.unknowns);
      return std::move(d_);
    }
    if (options_.most_held_out && held_out_error(d_) > *options_.most_held_out) return std::move(d_);
    if (!goes_on(0.1)) return stopped();
    rank_all();
    if (!goes_on(0.6)) return stopped();
    const auto fits = fit_the_best_in_full(
        session_, options_, search_, [this] { return goes_on(done_); }, d_);
    if (stopped_ || !goes_on(0.95)) return stopped();
    hold_back_rare_causes(d_);
    sort_candidates(d_.candidates);
    tell_apart();
    forget_what_was_seen();
    judge(session_, search_.noise_model.knowledge.known, fits, d_);
    if (options_.with_regions) d_.report.held_out_region = region_error(d_);
    d_.attribution = attribution_by_finding(d_.attribution, d_);
    for (DiagnosisCandidate& c : d_.candidates) {
      if (c.ln_bayes_factor >= d_.threshold && !c.unnamed) c.check = predicted_check(d_, c);
      c.explanation = explain(c, d_, session_);
    }
    return std::move(d_);
  }

  bool goes_on(double done) {
    done_ = done;
    if (!stopped_ && options_.on_progress && !options_.on_progress(done)) stopped_ = true;
    return !stopped_;
  }

  Diagnosis stopped() {
    d_.stopped = true;
    return std::move(d_);
  }

  void fit_the_model() {
    FitOptions base;
    base.effects = options_.effects;
    base.estimated = options_.estimated;
    base.start = options_.start;
    // Not exact, so that the robot's own error is no part of it: what is missing must not pass for that, and evidence
    // is weighed by a scatter of its own.
    base.smallest_step = 1e-9;
    if (!base.estimated.empty() && base.start) base.reuse_below = near_start;
    d_.model_options = base;
    base.on_iteration = options_.on_iteration;
    d_.model = options_.fitted ? *options_.fitted : fit_without_outliers(session_, base);
    stopped_ = d_.model.fit.solution.stopped;
    for (std::size_t t = 0; t < base.estimated.size(); ++t)
      d_.model_options.estimated[t] = d_.model.fit.effects[base.effects.size() + t].term;
    d_.model_options.start = estimate(d_.model.fit);
    d_.noise = d_.model.fit.noise;
    if (stopped_) return;
    d_.report = report(d_.model.session, d_.model.fit, d_.model_options);
    d_.observations = attribute_observations(session_, d_.model.fit);
    std::vector<ResidualParts> parts;
    for (const ObservationAttribution& o : d_.observations) parts.push_back(o.parts);
    if (d_.noise) d_.attribution = attribute_error(parts, *d_.noise);
  }

  void linearise() {
    const Fit& f = d_.model.fit;
    search_.noise_model = noise_model(f);
    search_.candidates = all_candidates(f.problem);
    search_.model = linear_model(search_.candidates.problem, estimate(f), search_.candidates.base_effects,
                                 search_.noise_model.noise);
  }

  void rank_all() {
    const Fit& f = d_.model.fit;
    linearise();
    search_.variables = list_variables(search_.candidates.problem, estimate(f));
    search_.ranking = rank(search_.model, search_.noise_model.knowledge, search_.candidates, search_.variables);
    d_.repeatability = search_.ranking.repeatability;
    set_threshold();
    if (const auto lack = lack_of_fit(f)) {
      d_.lack_of_fit_p = lack->p;
      d_.excess = lack->excess();
    }
    if (search_.noise_model.knowledge.known) {
      d_.beyond_repeatability = beyond_usual_repeatability(session_, f, search_.model, search_.noise_model.knowledge);
      d_.ln_against_usual_repeatability = find_ln_against_usual_repeatability(
          session_, f, search_.model, search_.noise_model.knowledge, d_.repeatability);
    }
    find_all_patterns();
    for (const RankedEffect& r : search_.ranking.effects) {
      if (r.visibility < least_seen && r.ln_bayes_factor < d_.threshold)
        d_.invisible.push_back(r.candidate->effect->id);
      d_.candidates.push_back(make_candidate(r, d_, search_.noise_model, session_));
    }
    add_impossible_effects();
    for (const RankedEmpiricalError& l : search_.ranking.empirical_errors)
      d_.candidates.push_back(make_candidate(l, session_));
    sort_candidates(d_.candidates);
  }

  /// A robot that has some effects has more: once names alone have brought the model here, scatter is no reason to ask
  /// more of the next name. It still is of what has none.
  void set_threshold() {
    if (options_.threshold) {
      d_.threshold = *options_.threshold;
      return;
    }
    const std::vector<EffectTerm>& terms = d_.model_options.estimated;
    const bool asks_less =
        d_.repeatability.is_any() && !terms.empty() && std::none_of(terms.begin(), terms.end(), is_curve);
    d_.threshold = known_threshold_ ? *known_threshold_
                                    : simulated_threshold(search_.model, search_.candidates, d_.repeatability,
                                                          search_.noise_model.knowledge) -
                                          (asks_less ? more_with_repeatability : 0);
    if (!asks_less) return;
    search_.odds_of_unnamed -= more_with_repeatability;
    for (RankedEmpiricalError& l : search_.ranking.empirical_errors) l.ln_bayes_factor -= more_with_repeatability;
  }

  /// What only another number of cameras, or a target, could have is not spoken of.
  bool is_of_this_rig(const std::string& id) const {
    const Effect& e = *find_effect(id, d_.model.fit.problem.source->own_effects);
    return (e.scope != EffectScope::camera || !e.cameras.empty()) && !has_no_target(e);
  }

  /// What this robot or session cannot have at all is invisible too.
  void add_impossible_effects() {
    const Fit& f = d_.model.fit;
    for (const Effect& e : catalogue())
      if (is_of_this_rig(e.id) &&
          std::none_of(search_.candidates.effects.begin(), search_.candidates.effects.end(),
                       [&](const CandidateEffect& c) { return c.effect->id == e.id; }) &&
          std::none_of(f.effects.begin(), f.effects.end(), [&](const FittedEffect& t) { return t.term.id == e.id; }))
        d_.invisible.push_back(e.id);
  }

  /// What the measurements speak for, or what is in the model, was seen: if not in every place that it could have.
  void forget_what_was_seen() {
    std::erase_if(d_.invisible, [&](const std::string& id) {
      return std::any_of(d_.candidates.begin(), d_.candidates.end(),
                         [&](const DiagnosisCandidate& c) {
                           const bool speaks = c.ln_bayes_factor >= d_.threshold || !c.held_back.empty();
                           return c.id == id && !c.unnamed && speaks;
                         }) ||
             std::any_of(d_.model.fit.effects.begin(), d_.model.fit.effects.end(),
                         [&](const FittedEffect& f) { return f.term.id == id; });
    });
  }

  void find_all_patterns() {
    const std::vector<ResidualSeries> series = residual_series(search_.candidates.problem, search_.model);
    for (const Pattern& p : find_patterns(series, search_.variables)) {
      if (p.p_value > significant_pattern || d_.patterns.size() >= most_patterns) break;
      d_.patterns.push_back({series[p.series], search_.variables[p.variable], p.strength, p.p_value});
    }
  }

  /// Which effects are nearly the same term on these poses, or too near in evidence; never one that the evidence
  /// clearly prefers, nor one that it leaves a million to one behind: from these the measurements do tell it.
  void tell_apart() {
    for (std::size_t i = 0; i < d_.candidates.size() && i < 12; ++i) {
      DiagnosisCandidate& a = d_.candidates[i];
      if (a.unnamed || a.ln_bayes_factor < 1) continue;
      for (const RankedEffect& other : search_.ranking.effects) {
        if (other.candidate->effect->id == a.id || other.visibility < least_visible_rival) continue;
        const auto b = std::find_if(d_.candidates.begin(), d_.candidates.end(),
                                    [&](const DiagnosisCandidate& c) { return c.id == other.candidate->effect->id; });
        if (b->ln_bayes_factor > a.ln_bayes_factor + ln_20 || b->ln_bayes_factor < a.ln_bayes_factor - ln_million)
          continue;
        const bool near = a.ln_bayes_factor >= d_.threshold && b->ln_bayes_factor > a.ln_bayes_factor - ln_20;
        if (near || overlap(a, other) > same_term) a.indistinguishable_from.push_back(b->id);
      }
    }
  }

  /// Share of a candidate's signal that another effect, at any of its places, can imitate.
  double overlap(const DiagnosisCandidate& a, const RankedEffect& other) {
    if (!plain_)
      plain_ = score(whiten(search_.model, {}, search_.noise_model.knowledge), 0, search_.model.candidates());
    return imitated_share(*plain_, find_ranked(search_.ranking, a.id), other);
  }

  const Session& session_;
  const DiagnosisOptions& options_;
  Diagnosis d_;
  LinearSearch search_;
  std::optional<Score> plain_;             // of all candidates, without scatter
  std::optional<double> known_threshold_;  // of a model that it was worked out for before
  double done_ = 0;
  bool stopped_ = false;
};

}  // namespace

Diagnosis diagnose(const Session& session, const DiagnosisOptions& options) {
  const auto sample = sample_to_judge(session);
  if (!sample) return Work(session, options).run();
  DiagnosisOptions of_sample = options;
  of_sample.fitted.reset();
  Diagnosis d = Work(sample->session, of_sample).run();
  check_on_the_others(session, *sample, d);
  return d;
}

Diagnosis diagnose_model(const Session& session, const DiagnosisOptions& options, Diagnosis model) {
  return Work(session, options).go_on(std::move(model));
}

double threshold_of(const Session& session, const DiagnosisOptions& options, const Diagnosis& model) {
  return Work(session, options).threshold(model);
}

}  // namespace handsight
