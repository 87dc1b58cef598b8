// SPDX-License-Identifier: Apache-2.0
// Touches of which everything is known: how much a hidden cause shows, what others leave of it, and what a judge says
// who knows the noise.
#pragma once

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "diagnosis/evidence/evidence.h"
#include "estimation/fit/fit.h"
#include "fixtures/touch_session.h"
#include "simulation/simulated_session.h"

namespace handsight::trials {

inline constexpr double reading = 2e-5;  // m

/// Touches without noise, weighed as if they had it.
inline Session exact_touches(const Session& like, int touches, std::uint64_t seed, const EffectTerm& term) {
  SimulationOptions o;
  o.observations = touches;
  o.seed = seed;
  o.noise = 1e-9;
  o.effects = {term};
  Session s = simulate_session(like, o).session;
  for (Fixture& f : s.fixtures) f.sigma = reading;
  for (Observation& observation : s.observations)
    for (Sighting& sighting : observation.sightings) sighting.point_sigma = reading;
  s.sigma_point = reading;
  return s;
}

/// chi-squared of what a model without the cause leaves of exact touches, in units of the noise.
inline double noncentrality(const Session& exact) {
  return fit(exact, {}).solution.normal.data_cost() / (reading * reading);
}

/// What is left of it where others are fitted in its place, their choices as they are: 2 ln of the odds by which noise
/// alone would let a perfect program prefer the truth.
inline double left_by(const Session& exact, const std::vector<EffectTerm>& others) {
  FitOptions o;
  for (const EffectTerm& t : others) o.estimated.push_back(term_of(term_effect(t), t.place));
  for (std::size_t i = 0; i < others.size(); ++i)
    for (std::size_t p = 0; p < others[i].values.size(); ++p)
      if (term_effect(others[i]).parameters[p].is_choice) o.estimated[i].values[p] = others[i].values[p];
  return fit(exact, o).solution.normal.cost / (reading * reading);
}

/// The other effects that leave least, each where it does best.
inline std::vector<std::pair<double, std::string>> nearest_to(const Session& exact, const std::string& truth) {
  std::vector<std::pair<double, std::string>> all;
  for (const Effect& effect : catalogue()) {
    if (effect.id == truth) continue;
    double least = 1e300;
    for (const int place : effect_places(effect, make_chain(exact))) try {
        least = std::min(least, left_by(exact, {term_of(effect, place)}));
      } catch (const std::exception&) {
      }
    all.emplace_back(least, effect.id);
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// ln of the Bayes factor of an effect at a place, its noise known and nothing else beside it: Laplace's, with the
/// priors that the diagnosis has.
inline double judged_ln_bayes_factor(const Session& s, double cost_without, const EffectTerm& zero) {
  FitOptions o;
  o.estimated = {zero};
  const Fit f = fit(s, o);
  const double unit = reading * reading;
  const Eigen::Index first = f.problem.effect_column(), count = f.problem.effect_count();
  const Eigen::MatrixXd covariance = unit * unit_covariance(f.solution).block(first, first, count, count);
  Eigen::VectorXd at(count), size(count);
  Eigen::Index k = 0;
  const EffectTerm& answer = f.effects.front().term;
  const Effect& effect = term_effect(answer);
  for (std::size_t p = 0; p < answer.values.size() && k < count; ++p) {
    if (effect.parameters[p].is_choice) continue;
    at[k] = answer.values[p];
    size[k++] = effect.parameters[p].sigma;
  }
  if (k != count) return -1e9;
  double sum = 0;
  for (std::size_t i = 0; i < prior_scales.size(); ++i) {
    Eigen::MatrixXd spread = covariance;
    spread.diagonal() += (prior_scales[i] * size).cwiseAbs2();
    const Eigen::LDLT<Eigen::MatrixXd> factor(spread);
    const double ln_volume =
        0.5 * (std::log(std::max(covariance.determinant(), 1e-300)) - factor.vectorD().array().log().sum());
    sum += scale_shares[i] * std::exp(ln_volume - 0.5 * at.dot(factor.solve(at)) + 300);
  }
  const double gain = 0.5 * (cost_without - f.solution.normal.cost) / unit;
  return gain + std::log(std::max(sum, 1e-300)) - 300;
}

/// What a judge says of a session who knows the noise, that one cause is hidden, and how large each usually is: ln of
/// the Bayes factor of each effect, where it does best.
using Judgement = std::map<std::string, double>;

inline Judgement judge(const Session& s) {
  const double without = fit(s, {}).solution.normal.cost;
  Judgement judgement;
  for (const Effect& effect : catalogue())
    for (const int place : effect_places(effect, make_chain(s))) {
      try {
        const double ln = judged_ln_bayes_factor(s, without, term_of(effect, place));
        const auto [at, is_new] = judgement.emplace(effect.id, ln);
        if (!is_new) at->second = std::max(at->second, ln);
      } catch (const std::exception&) {
      }
    }
  return judgement;
}

/// The effect with the most evidence beside this one.
inline std::pair<std::string, double> find_rival(const Judgement& judgement, const std::string& id) {
  std::pair<std::string, double> best{"nothing", 0};
  for (const auto& [name, ln] : judgement)
    if (name != id && ln > best.second) best = {name, ln};
  return best;
}

inline double evidence_of(const Judgement& judgement, const std::string& id) {
  const auto at = judgement.find(id);
  return at == judgement.end() ? 0 : at->second;
}

}  // namespace handsight::trials
