// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/verdict/diagnosis.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <mutex>

#include "base/threads.h"
#include "diagnosis/evidence/lack_of_fit.h"
#include "diagnosis/evidence/repeatability_levels.h"
#include "diagnosis/evidence/threshold.h"
#include "diagnosis/ranking/curves.h"
#include "diagnosis/ranking/outlier_rejection.h"
#include "diagnosis/ranking/refitting.h"
#include "diagnosis/verdict/candidate_report.h"
#include "diagnosis/verdict/explanation.h"
#include "diagnosis/verdict/finding.h"
#include "diagnosis/verdict/judging.h"
#include "diagnosis/verdict/robot_check.h"
#include "diagnosis/verdict/sampled.h"
#include "effects/target_effects.h"

namespace handsight {
namespace {

constexpr double same_term = 0.98;                 // overlap of two effects' signals on these poses
constexpr double ln_million = 13.815510557964274;  // odds beyond which no overlap makes two causes one
constexpr double significant_pattern = 1e-3;
constexpr std::size_t most_patterns = 40;
constexpr double ln_of_idle = 4;   // what places that show little alone must bring together to stay
constexpr double least_seen = 30;  // chi-squared of a prior sigma that poses must show
constexpr double least_visible_rival = 1;
constexpr std::size_t most_curves = 4;   // that are written as formulas
constexpr double next_to_nothing = 0.1;  // of what the model misses
constexpr double near_start = 1e-4;      // m, rad: a fit that begins at its own answer need not derive again

/// A number that no robot has and that leaves nearly all of the error has taken in a part of something else: a board
/// that seems bent in images from poses that are wrong.
bool is_stand_in(const DiagnosisCandidate& c) { return !c.plausible && c.explained.value_or(1) < next_to_nothing; }

/// The size of a pose sensor's target scales what was measured, and a scale of nothing would leave no error at all. The
/// density of the measurements themselves has the scale's logarithm for each of their coordinates.
double ln_of_scaled_places(const DiagnosisCandidate& c, const Session& session, const Fit& fit) {
  constexpr double least = 0.3;  // of the described size: less is another unit, not another print
  if (!session.pose_sensor || c.id != "target_scale") return 0;
  const double scale = 1 + c.terms.front().values.front();
  return scale < least ? -1e9 : 3 * static_cast<double>(fit.problem.observations.size()) * std::log(scale);
}

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
    for (const Repeatability& repeatability : repeatability_levels(model_, noise_model_.knowledge)) {
      const double evidence = whiten(model_, repeatability, noise_model_.knowledge).ln_evidence;
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
    refit_the_best();
    if (stopped_ || !goes_on(0.95)) return stopped();
    tell_apart();
    forget_what_was_seen();
    judge(session_, noise_model_.knowledge.known, fits_, d_);
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
    noise_model_ = noise_model(f);
    candidates_ = all_candidates(f.problem);
    model_ = linear_model(candidates_.problem, estimate(f), candidates_.base_effects, noise_model_.noise);
  }

  void rank_all() {
    const Fit& f = d_.model.fit;
    linearise();
    variables_ = list_variables(candidates_.problem, estimate(f));
    ranking_ = rank(model_, noise_model_.knowledge, candidates_, variables_);
    d_.repeatability = ranking_.repeatability;
    set_threshold();
    if (const auto lack = lack_of_fit(f)) {
      d_.lack_of_fit_p = lack->p;
      d_.excess = lack->excess();
    }
    if (noise_model_.knowledge.known) {
      d_.beyond_repeatability = beyond_usual_repeatability(session_, f, model_, noise_model_.knowledge);
      d_.ln_against_usual_repeatability =
          find_ln_against_usual_repeatability(session_, f, model_, noise_model_.knowledge, d_.repeatability);
    }
    find_all_patterns();
    for (const RankedEffect& r : ranking_.effects) {
      if (r.visibility < least_seen && r.ln_bayes_factor < d_.threshold)
        d_.invisible.push_back(r.candidate->effect->id);
      d_.candidates.push_back(make_candidate(r, d_, noise_model_, session_));
    }
    add_impossible_effects();
    for (const RankedEmpiricalError& l : ranking_.empirical_errors)
      d_.candidates.push_back(make_candidate(l, session_));
    sort_candidates();
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
    d_.threshold = known_threshold_
                       ? *known_threshold_
                       : simulated_threshold(model_, candidates_, d_.repeatability, noise_model_.knowledge) -
                             (asks_less ? more_with_repeatability : 0);
    if (!asks_less) return;
    odds_of_unnamed_ -= more_with_repeatability;
    for (RankedEmpiricalError& l : ranking_.empirical_errors) l.ln_bayes_factor -= more_with_repeatability;
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
          std::none_of(candidates_.effects.begin(), candidates_.effects.end(),
                       [&](const CandidateEffect& c) { return c.effect->id == e.id; }) &&
          std::none_of(f.effects.begin(), f.effects.end(), [&](const FittedEffect& t) { return t.term.id == e.id; }))
        d_.invisible.push_back(e.id);
  }

  /// What the measurements speak for, or what is in the model, was seen: if not in every place that it could have.
  void forget_what_was_seen() {
    std::erase_if(d_.invisible, [&](const std::string& id) {
      return std::any_of(d_.candidates.begin(), d_.candidates.end(),
                         [&](const DiagnosisCandidate& c) {
                           return c.id == id && !c.unnamed && c.ln_bayes_factor >= d_.threshold;
                         }) ||
             std::any_of(d_.model.fit.effects.begin(), d_.model.fit.effects.end(),
                         [&](const FittedEffect& f) { return f.term.id == id; });
    });
  }

  void sort_candidates() {
    std::stable_sort(d_.candidates.begin(), d_.candidates.end(),
                     [](const auto& a, const auto& b) { return a.ln_bayes_factor > b.ln_bayes_factor; });
  }

  void find_all_patterns() {
    const std::vector<ResidualSeries> series = residual_series(candidates_.problem, model_);
    for (const Pattern& p : find_patterns(series, variables_)) {
      if (p.p_value > significant_pattern || d_.patterns.size() >= most_patterns) break;
      d_.patterns.push_back({series[p.series], variables_[p.variable], p.strength, p.p_value});
    }
  }

  const RankedEffect& ranked(const std::string& id) const {
    return *std::find_if(ranking_.effects.begin(), ranking_.effects.end(),
                         [&](const RankedEffect& r) { return r.candidate->effect->id == id; });
  }

  /// The best named effects and the best curve in full, side by side: their evidence at the minimum in place of the
  /// linear one.
  void refit_the_best() {
    const std::vector<DiagnosisCandidate*> best = best_to_refit();
    const auto count = static_cast<int>(best.size());
    if (!ln_evidence_) ln_evidence_ = compute_ln_evidence(d_.model, noise_model_);
    each_part(count + 1, true, [&](int i) {
      if (i < count)
        refit_candidate(*best[static_cast<std::size_t>(i)]);
      else
        refit_the_curve();
    });
    if (stopped_) return;
    sort_candidates();
    refit_what_is_simpler();
  }

  std::vector<DiagnosisCandidate*> best_to_refit() {
    std::vector<DiagnosisCandidate*> best;
    const double top = d_.candidates.front().ln_bayes_factor;
    const double margin = std::max(10.0, 0.1 * std::max(top, 0.0));
    const auto few = static_cast<std::size_t>(options_.refitted);
    for (DiagnosisCandidate& c : d_.candidates) {
      if (c.unnamed) continue;
      const bool close = c.ln_bayes_factor > top - margin && best.size() < 2 * few;
      if (c.ln_bayes_factor < 1 || (best.size() >= few && !close)) break;
      if (!best.empty() && !close && c.ln_bayes_factor < d_.threshold) break;
      best.push_back(&c);
    }
    return best;
  }

  /// What the best one may stand in for, though to first order it says less: a turn of degrees is not of first order.
  void refit_what_is_simpler() {
    constexpr int most = 2;
    const DiagnosisCandidate best = d_.candidates.front();
    int done = 0;
    for (DiagnosisCandidate& c : d_.candidates) {
      if (stopped_ || done == most) break;
      if (c.unnamed || c.refitted || c.ln_bayes_factor < d_.threshold || !may_stand_in(best, c)) continue;
      refit_candidate(c);
      ++done;
    }
    if (done > 0) sort_candidates();
  }

  /// The unnamed candidates that pass as curves that the model may take in; the first one fitted in full.
  void refit_the_curve() {
    if (!options_.with_curves) return;
    std::size_t written = 0;
    for (DiagnosisCandidate& c : d_.candidates) {
      if (!c.unnamed || c.ln_bayes_factor < d_.threshold) continue;
      const auto curve = written == 0 ? curve_of(c, ranking_.empirical_errors) : curve_of(c, {*c.unnamed});
      if (!curve) continue;
      c.terms = {curve->term};
      c.sigmas = {std::vector<double>(curve->term.values.size(), 0.0)};
      c.where = {curve->where};
      if (written++ == 0) refit_curve(*curve, c);
      if (stopped_ || written == most_curves) return;
    }
  }

  std::optional<FoundCurve> curve_of(const DiagnosisCandidate& c,
                                     const std::vector<RankedEmpiricalError>& empirical_errors) {
    if (!whitened_ || !(whitened_->repeatability == c.repeatability))
      whitened_ = whiten(model_, c.repeatability, noise_model_.knowledge);
    return find_curve(*whitened_, noise_model_.knowledge, candidates_.problem, variables_, empirical_errors,
                      next_curve_id(list_terms(d_.model.fit)));
  }

  void refit_curve(const FoundCurve& curve, DiagnosisCandidate& c) {
    std::vector<FitIteration> path;
    const Refit r = refitted({curve.term}, path);
    if (stopped_ || !r.fit.converged()) return;
    const auto same =
        std::find_if(ranking_.empirical_errors.begin(), ranking_.empirical_errors.end(),
                     [&](const auto& l) { return l.empirical_error.variable->name.english() == curve.variable; });
    if (same != ranking_.empirical_errors.end()) c.unnamed = *same;
    take_refit(r, curve.ln_ways - odds_of_unnamed_, d_, noise_model_, session_, c);
    c.where = {curve.where};
    c.path = std::move(path);
    if (options_.with_held_out) c.held_out = report(d_.model.session, r.fit, r.options).held_out;
  }

  void refit_candidate(DiagnosisCandidate& c) {
    c.terms = with_settled_orders(d_.model, c.terms, noise_model_);
    c.where = list_places(c.terms, session_);
    std::vector<FitIteration> path;
    Refit r = refitted(c.terms, path);
    // Of a fit that has not ended the evidence is less than it could be; that may be more than was thought.
    const bool tells_more = r.fit.solution.normal.in_front && r.ln_bayes_factor > c.ln_bayes_factor;
    if (stopped_ || (!r.fit.converged() && !tells_more)) return;
    drop_idle_places(r, path);
    if (stopped_) return;
    take_refit(r, ranked(c.id).ln_best - ranked(c.id).ln_bayes_factor, d_, noise_model_, session_, c);
    c.ln_bayes_factor += ln_of_scaled_places(c, session_, r.fit);
    if (is_stand_in(c)) c.ln_bayes_factor = std::min(c.ln_bayes_factor, 0.0);
    c.path = std::move(path);
    if (options_.with_held_out) c.held_out = report(d_.model.session, r.fit, r.options).held_out;
    const std::scoped_lock lock(one_at_a_time_);
    fits_[c.id] = std::move(r);
  }

  /// With a stop request asked for at every iteration.
  Refit refitted(const std::vector<EffectTerm>& terms, std::vector<FitIteration>& path) {
    FitOptions options = d_.model_options;
    path.clear();
    options.on_iteration = [this, &path](int, double cost, const Unknowns& unknowns) {
      path.push_back({cost, unknowns});
      const std::scoped_lock lock(one_at_a_time_);
      return goes_on(done_);
    };
    Refit r = refit_with(d_.model, options, terms, noise_model_, ln_evidence_);
    r.options.on_iteration = nullptr;
    return r;
  }

  /// Places that the linear search took in, and that show nothing once all is fitted.
  void drop_idle_places(Refit& r, std::vector<FitIteration>& path) {
    std::vector<EffectTerm> kept;
    for (std::size_t t = r.fit.effects.size() - r.added; t < r.fit.effects.size(); ++t) {
      const FittedEffect& e = r.fit.effects[t];
      double z2 = 0, numbers = 0;
      for (std::size_t p = 0; p < e.sigmas.size(); ++p)
        if (e.sigmas[p] > 0) {
          z2 += std::pow(e.term.values[p] / e.sigmas[p], 2);
          ++numbers;
        }
      if (z2 > 8 + 2 * numbers) kept.push_back(e.term);
    }
    if (kept.empty() || kept.size() == r.added) return;
    std::vector<FitIteration> other_path;
    Refit fewer = refitted(kept, other_path);
    if (!fewer.fit.converged() || fewer.ln_bayes_factor <= r.ln_bayes_factor - ln_of_idle) return;
    r = std::move(fewer);
    path = std::move(other_path);
  }

  /// Which effects are nearly the same term on these poses, or too near in evidence; never one that the evidence
  /// clearly prefers, nor one that it leaves a million to one behind: from these the measurements do tell it.
  void tell_apart() {
    for (std::size_t i = 0; i < d_.candidates.size() && i < 12; ++i) {
      DiagnosisCandidate& a = d_.candidates[i];
      if (a.unnamed || a.ln_bayes_factor < 1) continue;
      for (const RankedEffect& other : ranking_.effects) {
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
    if (!plain_) plain_ = score(whiten(model_, {}, noise_model_.knowledge), 0, model_.candidates());
    return imitated_share(*plain_, ranked(a.id), other);
  }

  const Session& session_;
  const DiagnosisOptions& options_;
  Diagnosis d_;
  NoiseModel noise_model_;
  Candidates candidates_;
  LinearModel model_;
  std::vector<Variable> variables_;
  Ranking ranking_;
  std::optional<WhitenedModel> whitened_;  // for the last curve that was sought
  std::optional<Score> plain_;             // of all candidates, without scatter
  std::map<std::string, Refit> fits_;
  std::optional<double> ln_evidence_;      // of the model; absent: not asked yet
  std::optional<double> known_threshold_;  // of a model that it was worked out for before
  double odds_of_unnamed_ = ln_odds_of_unnamed;
  double done_ = 0;
  std::atomic<bool> stopped_ = false;
  std::mutex one_at_a_time_;  // of candidates that are fitted side by side
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
