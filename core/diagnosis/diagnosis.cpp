// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/diagnosis.h"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <map>

#include "diagnosis/explanation.h"
#include "diagnosis/refitting.h"
#include "diagnosis/threshold.h"

namespace handsight {
namespace {

constexpr std::size_t fewest_observations = 10;
constexpr double ln_20 = 2.995732273553991;  // odds beyond which a rival is out
constexpr double same_term = 0.98;           // overlap of two effects' signals on these poses
constexpr double significant_pattern = 1e-3;
constexpr int most_orders = 24;
constexpr double ln_of_idle = 4;   // what places that show little alone must bring together to stay
constexpr double least_seen = 30;  // chi-squared of a plausible size that poses must show

/// What is known of the noise, and the noise itself for weighing.
struct Weighing {
  NoiseKnowledge knowledge;
  double noise = 1;
};

Weighing weighing(const Fit& f) {
  Weighing w;
  if (f.noise_estimate && f.noise_estimate->sigma > 0 && f.noise_estimate->degrees >= 30) {
    w.noise = f.noise_estimate->sigma;
  } else if (f.noise && *f.noise > 0) {
    w.noise = *f.noise;
  } else {
    w.knowledge = {false, static_cast<double>(std::max(f.rows - f.unknowns, 1))};
    w.noise = std::max(f.residual_rms, 1e-12);
  }
  return w;
}

std::vector<EffectTerm> terms_with_values(const RankedEffect& r) {
  std::vector<EffectTerm> terms;
  Eigen::Index i = 0;
  for (const std::size_t u : r.units) {
    EffectTerm term = r.candidate->units[u].term;
    const Effect& effect = *r.candidate->effect;
    for (std::size_t p = 0; p < effect.parameters.size(); ++p)
      if (!effect.parameters[p].is_choice) term.values[p] = r.estimate.value[i++] * effect.parameters[p].sigma;
    terms.push_back(term);
  }
  return terms;
}

std::vector<std::vector<double>> sigmas_of(const RankedEffect& r) {
  std::vector<std::vector<double>> sigmas;
  Eigen::Index i = 0;
  const Effect& effect = *r.candidate->effect;
  for (std::size_t unit = 0; unit < r.units.size(); ++unit) {
    sigmas.emplace_back(effect.parameters.size(), 0.0);
    for (std::size_t p = 0; p < effect.parameters.size(); ++p)
      if (!effect.parameters[p].is_choice) {
        sigmas.back()[p] = std::sqrt(std::max(r.estimate.covariance(i, i), 0.0)) * effect.parameters[p].sigma;
        ++i;
      }
  }
  return sigmas;
}

bool is_plausible(const std::vector<EffectTerm>& terms) {
  for (const EffectTerm& term : terms) {
    const Effect& effect = *find_effect(term.id);
    for (std::size_t p = 0; p < effect.parameters.size(); ++p)
      if (!effect.parameters[p].is_choice && std::abs(term.values[p]) > 3 * effect.parameters[p].sigma) return false;
  }
  return true;
}

double p_of(double squares, int parameters) {
  if (!(squares > 0) || parameters <= 0) return 1;
  return boost::math::cdf(boost::math::complement(boost::math::chi_squared(parameters), squares));
}

/// rms that is left once chi-squared falls by `gained`, at poses not fitted.
std::optional<double> predicted_held_out(const Fit& f, double noise, double gained, int parameters) {
  if (f.rows <= f.unknowns + parameters) return std::nullopt;
  const double squares =
      std::max(f.solution.normal.data_cost() - gained * noise * noise, 0.0) / (f.rows - f.unknowns - parameters);
  return std::sqrt(squares * (1 + static_cast<double>(f.unknowns + parameters) / f.rows));
}

class Work {
 public:
  Work(const Session& session, const DiagnosisOptions& options) : session_(session), options_(options) {}

  Diagnosis run() {
    FitOptions base;
    base.effects = options_.effects;
    base.estimated = options_.estimated;
    base.start = options_.start;
    if (!base.estimated.empty()) base.smallest_step = 1e-9;
    d_.model = options_.fitted ? *options_.fitted : clean_fit(session_, base);
    if (!options_.fitted) keep_points_that_an_effect_explains(base);
    d_.model_options = base;
    for (std::size_t t = 0; t < base.estimated.size(); ++t)
      d_.model_options.estimated[t] = d_.model.fit.effects[base.effects.size() + t].term;
    d_.model_options.start = estimate(d_.model.fit);
    d_.report = report(d_.model.session, d_.model.fit, d_.model_options);
    d_.noise = d_.model.fit.noise;
    const Fit& f = d_.model.fit;
    if (f.problem.observations.size() < fewest_observations || f.rows - f.unknowns < 2 * f.unknowns) {
      d_.verdict = Verdict::too_few_observations;
      d_.reason = too_few_text(static_cast<int>(f.problem.observations.size()), f.rows - f.unknowns, f.unknowns);
      return std::move(d_);
    }
    if (!goes_on(0.1)) return stopped();
    rank_all();
    if (!goes_on(0.6)) return stopped();
    refit_the_best();
    if (!goes_on(0.95)) return stopped();
    tell_apart();
    judge();
    for (DiagnosisCandidate& c : d_.candidates) c.explanation = explain(c, d_, session_);
    return std::move(d_);
  }

 private:
  bool goes_on(double done) const { return !options_.on_progress || options_.on_progress(done); }

  Diagnosis stopped() {
    d_.stopped = true;
    return std::move(d_);
  }

  /// What looks like wrong points may be an effect that moves single markers or cameras. If one of the catalogue makes
  /// most of them right, they are none, and stay in.
  void keep_points_that_an_effect_explains(const FitOptions& base) {
    constexpr std::size_t fewest = 4, most_tried = 3;
    if (d_.model.wrong.size() < fewest) return;
    const CleanFit whole{session_, fit(session_, base), {}};
    const Weighing w = weighing(d_.model.fit);
    const Candidates candidates = all_candidates(whole.fit.problem, most_orders);
    const LinearModel linear = linear_model(candidates.problem, estimate(whole.fit), candidates.base_effects, w.noise);
    const Ranking ranking = rank(linear, w.knowledge, candidates, {});
    for (std::size_t i = 0; i < std::min(most_tried, ranking.effects.size()); ++i) {
      if (ranking.effects[i].ln_bayes_factor < 10) return;
      FitOptions with = base;
      const std::vector<EffectTerm> terms =
          with_settled_orders(whole, terms_with_values(ranking.effects[i]), w.noise, w.knowledge);
      with.estimated.insert(with.estimated.end(), terms.begin(), terms.end());
      CleanFit alternative = clean_fit(session_, with);
      if (2 * alternative.wrong.size() > d_.model.wrong.size()) continue;
      d_.model.session = std::move(alternative.session);
      d_.model.wrong = std::move(alternative.wrong);
      d_.model.fit = fit(d_.model.session, base);
      return;
    }
  }

  void rank_all() {
    const Fit& f = d_.model.fit;
    weighing_ = weighing(f);
    candidates_ = all_candidates(f.problem, most_orders);
    model_ = linear_model(candidates_.problem, estimate(f), candidates_.base_effects, weighing_.noise);
    variables_ = variables_of(candidates_.problem, estimate(f));
    ranking_ = rank(model_, weighing_.knowledge, candidates_, variables_);
    d_.scatter = ranking_.scatter;
    d_.threshold = options_.threshold ? *options_.threshold
                                      : simulated_threshold(model_, candidates_, d_.scatter, weighing_.knowledge);
    const auto lack = lack_of_fit(f);
    if (lack) {
      d_.lack_of_fit_p = lack->p;
      d_.excess = lack->excess();
    }
    find_all_patterns();
    for (const RankedEffect& r : ranking_.effects) {
      if (r.visibility < least_seen) d_.invisible.push_back(r.candidate->effect->id);
      d_.candidates.push_back(candidate_of(r));
    }
    for (const Effect& e : catalogue())  // what this robot or session cannot have at all
      if (std::none_of(candidates_.effects.begin(), candidates_.effects.end(),
                       [&](const CandidateEffect& c) { return c.effect == &e; }) &&
          std::none_of(f.effects.begin(), f.effects.end(), [&](const FittedEffect& t) { return t.term.id == e.id; }))
        d_.invisible.push_back(e.id);
    for (const RankedLocaliser& l : ranking_.localisers) d_.candidates.push_back(candidate_of(l));
    sort_candidates();
  }

  void sort_candidates() {
    std::stable_sort(d_.candidates.begin(), d_.candidates.end(),
                     [](const auto& a, const auto& b) { return a.ln_bayes_factor > b.ln_bayes_factor; });
  }

  DiagnosisCandidate candidate_of(const RankedEffect& r) const {
    const Fit& f = d_.model.fit;
    DiagnosisCandidate c;
    c.id = r.candidate->effect->id;
    c.terms = terms_with_values(r);
    c.sigmas = sigmas_of(r);
    c.where = places_of(c.terms, session_);
    c.ln_bayes_factor = r.ln_bayes_factor;
    c.p_value = p_of(r.gained_squares, r.parameters);
    c.scatter = r.scatter;
    c.visibility = r.visibility;
    c.plausible = is_plausible(c.terms);
    c.predicted_held_out = predicted_held_out(f, weighing_.noise, r.gained_squares, r.parameters);
    if (d_.excess && *d_.excess > 60 && d_.lack_of_fit_p < 1e-3)
      c.explained = std::clamp((r.gained_squares - r.parameters) / *d_.excess, 0.0, 1.0);
    return c;
  }

  DiagnosisCandidate candidate_of(const RankedLocaliser& l) const {
    DiagnosisCandidate c;
    c.unnamed = l;
    c.ln_bayes_factor = l.ln_bayes_factor;
    c.scatter = l.scatter;
    if (l.localiser.variable->joint >= 0)
      c.where = {session_.robot.joints[static_cast<std::size_t>(l.localiser.variable->joint)].name};
    return c;
  }

  void find_all_patterns() {
    const std::vector<ResidualSeries> series = residual_series(candidates_.problem, model_);
    for (const Pattern& p : find_patterns(series, variables_)) {
      if (p.p_value > significant_pattern || d_.patterns.size() >= 40) break;
      d_.patterns.push_back({series[p.series], variables_[p.variable], p.strength, p.p_value});
    }
  }

  /// The best named effects in full: their evidence at the minimum in place of the linear one.
  void refit_the_best() {
    int done = 0;
    const double top = d_.candidates.front().ln_bayes_factor;
    const double margin = std::max(10.0, 0.1 * std::max(top, 0.0));
    for (DiagnosisCandidate& c : d_.candidates) {
      if (c.unnamed) continue;
      const bool close = c.ln_bayes_factor > top - margin && done < 2 * options_.refitted;
      if (c.ln_bayes_factor < 1 || (done >= options_.refitted && !close)) break;
      if (done > 0 && !close && c.ln_bayes_factor < d_.threshold) break;
      refit_candidate(c);
      if (!goes_on(0.6 + 0.3 * ++done / (2.0 * options_.refitted))) return;
    }
    sort_candidates();
  }

  void refit_candidate(DiagnosisCandidate& c) {
    const auto ranked = std::find_if(ranking_.effects.begin(), ranking_.effects.end(),
                                     [&](const RankedEffect& r) { return r.candidate->effect->id == c.id; });
    c.terms = with_settled_orders(d_.model, c.terms, weighing_.noise, weighing_.knowledge);
    c.where = places_of(c.terms, session_);
    Refit r = refit_with(d_.model, d_.model_options, c.terms, weighing_.noise, weighing_.knowledge);
    if (!r.fit.converged()) return;
    drop_idle_places(r);
    c.refitted = true;
    c.terms.clear();
    c.sigmas.clear();
    c.where.clear();
    for (std::size_t t = r.fit.effects.size() - r.added; t < r.fit.effects.size(); ++t) {
      c.terms.push_back(r.fit.effects[t].term);
      c.sigmas.push_back(r.fit.effects[t].sigmas);
    }
    c.where = places_of(c.terms, session_);
    const double gained = (d_.model.fit.solution.normal.data_cost() - r.fit.solution.normal.data_cost()) /
                          (weighing_.noise * weighing_.noise);
    c.predicted_held_out =
        predicted_held_out(d_.model.fit, weighing_.noise, gained, r.fit.unknowns - d_.model.fit.unknowns);
    c.plausible = is_plausible(c.terms);
    c.ln_bayes_factor = r.ln_bayes_factor + ranked->ln_bayes_factor - ranked->ln_best;
    if (const auto left = lack_of_fit(r.fit); left && d_.excess && *d_.excess > 60 && d_.lack_of_fit_p < 1e-3)
      c.explained = std::clamp(1 - left->excess() / *d_.excess, 0.0, 1.0);
    if (options_.with_held_out) {
      c.held_out = report(d_.model.session, r.fit, r.options).held_out;
    }
    lack_after_[c.id] = lack_of_fit(r.fit);
    fits_[c.id] = r;
  }

  /// Places that the linear search took in, and that show nothing once all is fitted.
  void drop_idle_places(Refit& r) const {
    std::vector<EffectTerm> kept;
    for (std::size_t t = r.fit.effects.size() - r.added; t < r.fit.effects.size(); ++t) {
      const FittedEffect& e = r.fit.effects[t];
      double z2 = 0, numbers = 0;
      for (std::size_t p = 0; p < e.sigmas.size(); ++p)
        if (e.sigmas[p] > 0) {
          z2 += std::pow(e.term.values[p] / e.sigmas[p], 2);
          ++numbers;
        }
      if (z2 > 6 + 2 * numbers) kept.push_back(e.term);
    }
    if (kept.empty() || kept.size() == r.added) return;
    Refit fewer = refit_with(d_.model, d_.model_options, kept, weighing_.noise, weighing_.knowledge);
    if (fewer.fit.converged() && fewer.ln_bayes_factor > r.ln_bayes_factor - ln_of_idle) r = std::move(fewer);
  }

  /// Which effects are nearly the same term on these poses, or too near in evidence.
  void tell_apart() {
    for (std::size_t i = 0; i < d_.candidates.size() && i < 12; ++i) {
      DiagnosisCandidate& a = d_.candidates[i];
      if (a.unnamed || a.ln_bayes_factor < 1) continue;
      for (const RankedEffect& other : ranking_.effects) {
        if (other.candidate->effect->id == a.id || other.visibility < least_visible_rival) continue;
        const auto b = std::find_if(d_.candidates.begin(), d_.candidates.end(),
                                    [&](const DiagnosisCandidate& c) { return c.id == other.candidate->effect->id; });
        const bool near = a.ln_bayes_factor >= d_.threshold && b->ln_bayes_factor > a.ln_bayes_factor - ln_20;
        if (near || overlap(a, other) > same_term) a.cannot_be_told_from.push_back(b->id);
      }
    }
  }

  /// Share of a candidate's signal that another effect, at any of its places, can imitate.
  double overlap(const DiagnosisCandidate& a, const RankedEffect& other) {
    if (!plain_) plain_ = whiten(model_, 0, weighing_.knowledge);
    const auto ranked = std::find_if(ranking_.effects.begin(), ranking_.effects.end(),
                                     [&](const RankedEffect& r) { return r.candidate->effect->id == a.id; });
    return imitated_share(*plain_, *ranked, other);
  }

  void judge() {
    const bool knows_noise = weighing_.knowledge.known;
    const DiagnosisCandidate* best = nullptr;
    const DiagnosisCandidate* unnamed = nullptr;
    for (const DiagnosisCandidate& c : d_.candidates) {
      if (c.unnamed && !unnamed) unnamed = &c;
      if (!c.unnamed && !best) best = &c;
    }
    const bool named_passes = best && best->ln_bayes_factor >= d_.threshold;
    const bool unnamed_passes = unnamed && unnamed->ln_bayes_factor >= d_.threshold;
    if (unnamed_passes && (!best || unnamed->ln_bayes_factor > best->ln_bayes_factor)) {
      d_.verdict = Verdict::unexplained;
      d_.reason = follows_unnamed_text(*unnamed, session_);
      put_variable_first(*unnamed->unnamed->localiser.variable);
      return;
    }
    if (!named_passes) {
      judge_what_is_left(knows_noise);
      return;
    }
    const bool rival = std::any_of(d_.candidates.begin(), d_.candidates.end(), [&](const DiagnosisCandidate& c) {
      return !c.unnamed && &c != best && c.ln_bayes_factor > best->ln_bayes_factor - ln_20;
    });
    if (explains_too_little(*best)) {
      d_.verdict = Verdict::unexplained;
      d_.reason = too_little_text(*best, d_);
      return;
    }
    d_.verdict = rival ? Verdict::ambiguous : Verdict::missing_effect;
    d_.reason = missing_text(*best, rival, d_);
  }

  /// After the best named effect the model still fails, by more than half, and no further named effect would help.
  bool explains_too_little(const DiagnosisCandidate& best) {
    const auto after = lack_after_.find(best.id);
    if (after == lack_after_.end() || !after->second || !best.explained) return false;
    if (after->second->p >= 1e-3 || *best.explained >= 0.5) return false;
    return !further_effect_passes(fits_.at(best.id), d_.threshold);
  }

  void judge_what_is_left(bool knows_noise) {
    if (!knows_noise) {
      d_.verdict = Verdict::unexplained;
      d_.reason = unknown_noise_text(d_);
      return;
    }
    const bool fails = d_.lack_of_fit_p && *d_.lack_of_fit_p < 1e-3;
    if (fails && !d_.patterns.empty() && d_.patterns.front().p_value < 1e-4 && d_.patterns.front().strength > 0.2) {
      d_.verdict = Verdict::unexplained;
      d_.reason = follows_pattern_text(d_.patterns.front());
      return;
    }
    d_.verdict = Verdict::adequate;
    d_.reason = adequate_text(d_, fails);
  }

  void put_variable_first(const Variable& variable) {
    std::stable_partition(d_.patterns.begin(), d_.patterns.end(), [&](const DiagnosisPattern& p) {
      return p.against.kind == variable.kind && p.against.joint == variable.joint;
    });
  }

  static constexpr double least_visible_rival = 1;

  const Session& session_;
  const DiagnosisOptions& options_;
  Diagnosis d_;
  Weighing weighing_;
  Candidates candidates_;
  LinearModel model_;
  std::vector<Variable> variables_;
  Ranking ranking_;
  std::optional<WhitenedModel> plain_;
  std::map<std::string, std::optional<LackOfFit>> lack_after_;
  std::map<std::string, Refit> fits_;
};

}  // namespace

const char* verdict_text(Verdict verdict) {
  switch (verdict) {
    case Verdict::too_few_observations:
      return "too_few_observations";
    case Verdict::adequate:
      return "adequate";
    case Verdict::missing_effect:
      return "missing_effect";
    case Verdict::ambiguous:
      return "ambiguous";
    case Verdict::unexplained:
      return "unexplained";
  }
  return "";
}

Diagnosis diagnose(const Session& session, const DiagnosisOptions& options) { return Work(session, options).run(); }

}  // namespace handsight
