// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/ranking/ranking.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "base/combinations.h"
#include "base/threads.h"
#include "diagnosis/evidence/prior_odds.h"
#include "diagnosis/evidence/repeatability_levels.h"

namespace handsight {
namespace {

constexpr double least_visible = 1e-2;  // chi-squared of a prior sigma below which a unit is left out of choices
constexpr std::size_t most_in_pairs = 6;

std::vector<Eigen::Index> list_columns(const CandidateEffect& c, const std::vector<std::size_t>& units) {
  std::vector<Eigen::Index> columns;
  for (const std::size_t u : units)
    for (Eigen::Index i = 0; i < c.units[u].count; ++i) columns.push_back(c.units[u].first - c.units.front().first + i);
  return columns;
}

bool sits_at_joints(const Effect& e) { return e.scope == EffectScope::joint || e.scope == EffectScope::mimic_joint; }

/// Units that differ in a choice are ways of the same cause: all of them at once is no cause.
bool has_choices(const Effect& e) {
  return std::any_of(e.parameters.begin(), e.parameters.end(), [](const EffectParameter& p) { return p.is_choice; });
}

/// One effect under one scatter.
class EffectRanker {
 public:
  EffectRanker(const WhitenedModel& w, const NoiseKnowledge& noise, const CandidateEffect& candidate)
      : w_(w), noise_(noise), c_(candidate) {}

  /// The best choice of places, searched further than pairs.
  void search_places(RankedEffect& r) {
    if (!sits_at_joints(*c_.effect) || c_.units.size() < 3) return;
    const Eigen::Index first = c_.units.front().first;
    all_ = score(w_, first, c_.units.back().first + c_.units.back().count - first);
    std::vector<std::size_t> seen;
    for (std::size_t u = 0; u < c_.units.size(); ++u)
      if (take_part(all_, list_columns(c_, {u})).information.trace() >= least_visible) seen.push_back(u);
    if (seen.size() < 3) return;
    const double before = r.ln_best, shift = before - make_factor(r.units);  // the scatter's own share
    r.ln_best = make_factor(r.units);
    double best = r.ln_best - ln_choose(static_cast<double>(seen.size()), static_cast<double>(r.units.size()));
    extend(seen, seen.size(), best, r);
    r.ln_best += shift;
    std::sort(r.units.begin(), r.units.end());
    finish(take_part(all_, list_columns(c_, r.units)), r);
  }

  RankedEffect rank() {
    RankedEffect r;
    r.candidate = &c_;
    r.repeatability = w_.repeatability;
    if (sits_at_joints(*c_.effect)) {
      rank_joints(r);
    } else {
      rank_alternatives(r);
    }
    return r;
  }

  /// The numbers of the best choice, without scatter: what adding it would do to the plain residuals.
  void measure(RankedEffect& r) const {
    Score whole;
    if (r.units.size() == 1) {
      whole = score(w_, c_.units[r.units[0]].first, c_.units[r.units[0]].count);
    } else {
      const Eigen::Index first = c_.units.front().first;
      whole =
          take_part(score(w_, first, c_.units.back().first + c_.units.back().count - first), list_columns(c_, r.units));
    }
    finish(whole, r);
  }

 private:
  void finish(const Score& s, RankedEffect& r) const {
    r.estimate = linear_estimate(s, w_, noise_);
    r.gained_squares = 2 * s.gradient.dot(r.estimate.value) - r.estimate.value.dot(s.information * r.estimate.value);
    r.parameters = static_cast<int>(s.gradient.size());
  }

  /// One of several choices (markers, observations, forms) is true, or there is just one.
  void rank_alternatives(RankedEffect& r) const {
    std::vector<double> factors;
    Score best;
    for (std::size_t u = 0; u < c_.units.size(); ++u) {
      const Score s = score(w_, c_.units[u].first, c_.units[u].count);
      r.visibility = std::max(r.visibility, s.information.trace());
      factors.push_back(ln_bayes_factor(s, w_, noise_));
      if (u > 0 && factors.back() <= r.ln_best) continue;
      r.ln_best = factors.back();
      r.units = {u};
      best = s;
    }
    r.ln_bayes_factor = ln_mean_exp(factors);
    finish(best, r);
  }

  double make_factor(const std::vector<std::size_t>& units) const {
    return ln_bayes_factor(take_part(all_, list_columns(c_, units)), w_, noise_);
  }

  /// One joint, a pair, some, or all of them.
  void rank_joints(RankedEffect& r) {
    const Eigen::Index first = c_.units.front().first;
    all_ = score(w_, first, c_.units.back().first + c_.units.back().count - first);
    r.visibility = all_.information.trace();
    std::vector<std::size_t> seen;
    std::vector<double> singles;
    for (std::size_t u = 0; u < c_.units.size(); ++u) {
      const Score s = take_part(all_, list_columns(c_, {u}));
      if (s.information.trace() < least_visible) continue;
      seen.push_back(u);
      singles.push_back(ln_bayes_factor(s, w_, noise_));
    }
    if (seen.empty()) {
      r.units = {0};
      finish(take_part(all_, list_columns(c_, r.units)), r);
      return;
    }
    const std::size_t n = seen.size();
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return singles[a] > singles[b]; });

    std::vector<double> classes{ln_mean_exp(singles)};
    r.units = {seen[order[0]]};
    double best = singles[order[0]] - std::log(static_cast<double>(n));
    r.ln_best = singles[order[0]];
    if (n > 1) {
      std::vector<double> pairs;
      for (std::size_t a = 0; a < n; ++a)
        for (std::size_t b = a + 1; b < n; ++b) {
          // Joints that show little alone seldom do in pairs: the better of the two stands for them.
          const bool exact = b < most_in_pairs || (a < 2 && b < 12);
          const double factor = exact ? make_factor({seen[order[a]], seen[order[b]]}) : singles[order[a]] - 1;
          pairs.push_back(factor);
          if (exact) take({seen[order[a]], seen[order[b]]}, factor, n, best, r);
        }
      classes.push_back(ln_mean_exp(pairs));
      if (n > 2 && !has_choices(*c_.effect)) {
        const double all = make_factor(seen);
        classes.push_back(all);
        take(seen, all, n, best, r);
      }
    }
    r.ln_bayes_factor = ln_mean_exp(classes);
    std::sort(r.units.begin(), r.units.end());
    finish(take_part(all_, list_columns(c_, r.units)), r);
  }

  void take(const std::vector<std::size_t>& units, double factor, std::size_t n, double& best, RankedEffect& r) const {
    const double value = factor - ln_choose(static_cast<double>(n), static_cast<double>(units.size()));
    if (value <= best) return;
    best = value;
    r.units = units;
    r.ln_best = factor;
  }

  /// From the best choice on, joint by joint, as long as that helps; then those that do not help are dropped.
  void extend(const std::vector<std::size_t>& seen, std::size_t n, double& best, RankedEffect& r) const {
    for (bool grown = true; grown && r.units.size() < n;) {
      grown = false;
      const std::vector<std::size_t> from = r.units;
      for (const std::size_t u : seen) {
        if (std::find(from.begin(), from.end(), u) != from.end()) continue;
        std::vector<std::size_t> more = from;
        more.push_back(u);
        const double before = best;
        take(more, make_factor(more), n, best, r);
        grown = grown || best > before;
      }
    }
    for (bool shrunk = true; shrunk && r.units.size() > 1;) {
      shrunk = false;
      const std::vector<std::size_t> from = r.units;
      for (std::size_t i = 0; i < from.size(); ++i) {
        std::vector<std::size_t> less = from;
        less.erase(less.begin() + static_cast<std::ptrdiff_t>(i));
        const double before = best;
        take(less, make_factor(less), n, best, r);
        shrunk = shrunk || best > before;
      }
    }
  }

  const WhitenedModel& w_;
  const NoiseKnowledge& noise_;
  const CandidateEffect& c_;
  Score all_;
};

/// Where the effects that matter sit: of the best by evidence. `w` is overwritten: two of them at once may not fit.
void search_places_of_the_best(const LinearModel& model, const NoiseKnowledge& noise, WhitenedModel& w,
                               Ranking& ranking) {
  constexpr std::size_t most = 4;
  std::vector<RankedEffect*> best;
  for (RankedEffect& r : ranking.effects)
    if (r.ln_bayes_factor > 1) best.push_back(&r);
  std::stable_sort(best.begin(), best.end(),
                   [](const auto* a, const auto* b) { return a->ln_bayes_factor > b->ln_bayes_factor; });
  if (best.size() > most) best.resize(most);
  for (const Repeatability& repeatability : ranking.scatters) {
    bool is_whitened = false;
    for (RankedEffect* r : best) {
      if (r->repeatability != repeatability) continue;
      if (!is_whitened) whiten(model, repeatability, noise, w);
      is_whitened = true;
      EffectRanker(w, noise, *r->candidate).search_places(*r);
    }
  }
}

}  // namespace

double ln_odds_of_unnamed_along(const Variable& variable) {
  return ln_odds_of_unnamed - (variable.kind == VariableKind::time ? ln_odds_against_drift : 0);
}

std::vector<EffectTerm> terms_with_values(const RankedEffect& r) {
  std::vector<EffectTerm> terms;
  Eigen::Index i = 0;
  for (const std::size_t u : r.units) {
    EffectTerm term = r.candidate->units[u].term;
    const Effect& effect = *r.candidate->effect;
    for (std::size_t p = 0; p < effect.parameters.size(); ++p)
      if (!effect.parameters[p].is_choice) term.values[p] = r.estimate.value[i++] * r.candidate->sizes[p];
    terms.push_back(term);
  }
  return terms;
}

Ranking rank(const LinearModel& model, const NoiseKnowledge& noise, const Candidates& candidates,
             const std::vector<Variable>& variables) {
  Ranking ranking;
  ranking.scatters = repeatability_levels(model, noise);
  std::vector<double> evidence;
  std::vector<std::vector<RankedEffect>> effects;
  std::vector<std::vector<EmpiricalError>> empirical_errors;
  WhitenedModel w;
  for (const Repeatability& repeatability : ranking.scatters) {
    whiten(model, repeatability, noise, w);
    evidence.push_back(w.ln_evidence);
    effects.emplace_back(candidates.effects.size());
    each_part(static_cast<int>(candidates.effects.size()), true, [&](int i) {
      const auto e = static_cast<std::size_t>(i);
      effects.back()[e] = EffectRanker(w, noise, candidates.effects[e]).rank();
    });
    empirical_errors.push_back(localise(w, noise, candidates.problem, variables));
  }
  const auto top = std::max_element(evidence.begin(), evidence.end());
  ranking.repeatability = ranking.scatters[static_cast<std::size_t>(top - evidence.begin())];
  for (std::size_t e = 0; e < effects.front().size(); ++e) {
    std::size_t best = 0;
    for (std::size_t s = 1; s < evidence.size(); ++s)
      if (evidence[s] + effects[s][e].ln_bayes_factor > evidence[best] + effects[best][e].ln_bayes_factor) best = s;
    RankedEffect r = effects[best][e];
    r.ln_bayes_factor += evidence[best] - *top - ln_odds_against(r.candidate->units.front().term);
    r.ln_best += evidence[best] - *top;
    r.visibility = effects[0][e].visibility;
    ranking.effects.push_back(std::move(r));
  }
  for (std::size_t l = 0; l < empirical_errors.front().size(); ++l) {
    std::size_t best = 0;
    for (std::size_t s = 1; s < evidence.size(); ++s)
      if (evidence[s] + empirical_errors[s][l].ln_bayes_factor >
          evidence[best] + empirical_errors[best][l].ln_bayes_factor)
        best = s;
    const double factor = empirical_errors[best][l].ln_bayes_factor + evidence[best] - *top +
                          ln_odds_of_unnamed_along(*empirical_errors[best][l].variable);
    ranking.empirical_errors.push_back({empirical_errors[best][l], factor, ranking.scatters[best]});
  }
  search_places_of_the_best(model, noise, w, ranking);
  whiten(model, {}, noise, w);
  each_part(static_cast<int>(ranking.effects.size()), true, [&](int i) {
    RankedEffect& r = ranking.effects[static_cast<std::size_t>(i)];
    EffectRanker(w, noise, *r.candidate).measure(r);
  });
  const auto better = [](const auto& a, const auto& b) { return a.ln_bayes_factor > b.ln_bayes_factor; };
  std::stable_sort(ranking.effects.begin(), ranking.effects.end(), better);
  std::stable_sort(ranking.empirical_errors.begin(), ranking.empirical_errors.end(), better);
  return ranking;
}

}  // namespace handsight
