// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/verdict/full_fits.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

#include "base/threads.h"
#include "diagnosis/evidence/prior_odds.h"
#include "diagnosis/ranking/curves.h"
#include "diagnosis/space/spreading.h"
#include "diagnosis/verdict/candidate_report.h"
#include "diagnosis/verdict/finding.h"
#include "diagnosis/verdict/small_beside.h"

namespace handsight {
namespace {

constexpr double ln_of_idle = 4;         // what places that show little alone must bring together to stay
constexpr std::size_t most_curves = 4;   // that are written as formulas
constexpr double next_to_nothing = 0.1;  // of what the model misses

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

class FullFits {
 public:
  FullFits(const Session& session, const DiagnosisOptions& options, const LinearSearch& search,
           const std::function<bool()>& goes_on, Diagnosis& diagnosis)
      : session_(session), options_(options), search_(search), goes_on_(goes_on), d_(diagnosis) {}

  std::map<std::string, Refit> run() {
    const std::vector<DiagnosisCandidate*> best = best_to_refit();
    const auto count = static_cast<int>(best.size());
    ln_evidence_ = compute_ln_evidence(d_.model, search_.noise_model);
    each_part(count + 1, true, [&](int i) {
      if (i < count)
        refit_candidate(*best[static_cast<std::size_t>(i)]);
      else
        refit_the_curve();
    });
    if (!stopped_) {
      sort_candidates(d_.candidates);
      refit_what_is_simpler();
      weigh_beside_small();
    }
    return std::move(fits_);
  }

 private:
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
    if (done > 0) sort_candidates(d_.candidates);
  }

  /// What the best one may stand in for and that explains most of the same, and the best one itself.
  void weigh_beside_small() {
    DiagnosisCandidate& best = d_.candidates.front();
    if (stopped_ || best.unnamed || !best.refitted || !best.explained) return;
    // Of what the best one explains: one that is small in every robot has taken in small deviations of its own kind.
    const double most = small_in_every_robot().contains(best.id) ? 0.6 : 0.8;
    std::vector<DiagnosisCandidate*> asked{&best};
    for (DiagnosisCandidate& c : d_.candidates)
      if (&c != &best && !c.unnamed && c.refitted && c.ln_bayes_factor >= d_.threshold && may_stand_in(best, c) &&
          c.explained.value_or(0) >= most * *best.explained)
        asked.push_back(&c);
    if (asked.size() == 1) return;
    each_part(static_cast<int>(asked.size()), true, [&](int i) {
      DiagnosisCandidate& c = *asked[static_cast<std::size_t>(i)];
      const double gain = gain_by_small_deviations(fits_.at(c.id), [this](const std::vector<EffectTerm>& terms) {
        std::vector<FitIteration> path;
        return refitted(terms, path);
      });
      if (!stopped_) c.ln_of_small = gain;
    });
  }

  /// The unnamed candidates that pass as curves that the model may take in; the first one fitted in full.
  void refit_the_curve() {
    if (!options_.with_curves) return;
    std::size_t written = 0;
    for (DiagnosisCandidate& c : d_.candidates) {
      if (!c.unnamed || c.ln_bayes_factor < d_.threshold) continue;
      const auto curve = written == 0 ? curve_of(c, search_.ranking.empirical_errors) : curve_of(c, {*c.unnamed});
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
      whitened_ = whiten(search_.model, c.repeatability, search_.noise_model.knowledge);
    return find_curve(*whitened_, search_.noise_model.knowledge, search_.candidates.problem, search_.variables,
                      empirical_errors, next_curve_id(list_terms(d_.model.fit)));
  }

  void refit_curve(const FoundCurve& curve, DiagnosisCandidate& c) {
    std::vector<FitIteration> path;
    const Refit r = refitted({curve.term}, path);
    if (stopped_ || !r.fit.converged()) return;
    const auto same =
        std::find_if(search_.ranking.empirical_errors.begin(), search_.ranking.empirical_errors.end(),
                     [&](const auto& l) { return l.empirical_error.variable->name.english() == curve.variable; });
    if (same != search_.ranking.empirical_errors.end()) c.unnamed = *same;
    const double rare = is_curve_of_time(curve.term) ? ln_odds_against_drift : 0;
    take_refit(r, curve.ln_ways + rare - search_.odds_of_unnamed, d_, search_.noise_model, session_, c);
    c.where = {curve.where};
    c.path = std::move(path);
    if (options_.with_held_out) c.held_out = report(d_.model.session, r.fit, r.options).held_out;
  }

  void refit_candidate(DiagnosisCandidate& c) {
    c.terms = with_settled_orders(d_.model, c.terms, search_.noise_model);
    c.where = list_places(c.terms, session_);
    std::vector<FitIteration> path;
    Refit r = refitted(c.terms, path);
    // Of a fit that has not ended the evidence is less than it could be; that may be more than was thought.
    const bool tells_more = r.fit.solution.normal.in_front && r.ln_bayes_factor > c.ln_bayes_factor;
    if (stopped_ || (!r.fit.converged() && !tells_more)) return;
    drop_idle_places(r, path);
    if (stopped_) return;
    const RankedEffect& ranked = find_ranked(search_.ranking, c.id);
    take_refit(r, ranked.ln_best - ranked.ln_bayes_factor, d_, search_.noise_model, session_, c);
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
      if (!stopped_ && !goes_on_()) stopped_ = true;
      return !stopped_;
    };
    Refit r = refit_with(d_.model, options, terms, search_.noise_model, ln_evidence_);
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

  const Session& session_;
  const DiagnosisOptions& options_;
  const LinearSearch& search_;
  const std::function<bool()>& goes_on_;
  Diagnosis& d_;
  std::optional<WhitenedModel> whitened_;  // for the last curve that was sought
  std::map<std::string, Refit> fits_;
  double ln_evidence_ = 0;  // of the model
  std::atomic<bool> stopped_ = false;
  std::mutex one_at_a_time_;  // of candidates that are fitted side by side
};

}  // namespace

const RankedEffect& find_ranked(const Ranking& ranking, const std::string& id) {
  return *std::find_if(ranking.effects.begin(), ranking.effects.end(),
                       [&](const RankedEffect& r) { return r.candidate->effect->id == id; });
}

void sort_candidates(std::vector<DiagnosisCandidate>& candidates) {
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const auto& a, const auto& b) { return a.ln_bayes_factor > b.ln_bayes_factor; });
}

std::map<std::string, Refit> fit_the_best_in_full(const Session& session, const DiagnosisOptions& options,
                                                  const LinearSearch& search, const std::function<bool()>& goes_on,
                                                  Diagnosis& diagnosis) {
  return FullFits(session, options, search, goes_on, diagnosis).run();
}

}  // namespace handsight
