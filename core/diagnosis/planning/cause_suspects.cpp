// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/planning/cause_suspects.h"

#include <algorithm>
#include <cmath>

namespace handsight {
namespace {

constexpr std::size_t places_of_an_effect = 3;

bool begins_at_a_moment(const Effect& effect) {
  return std::any_of(effect.parameters.begin(), effect.parameters.end(),
                     [](const EffectParameter& p) { return p.is_choice && p.choices.empty(); });
}

/// By the evidence of its own numbers; `probability` is ln of its Bayes factor, still.
Suspect make_suspect(std::size_t effect, const CandidateUnit& unit, const WhitenedModel& model,
                     const NoiseKnowledge& noise) {
  const Score s = score(model, unit.first, unit.count);
  Suspect suspect{effect, unit.first, unit.count, ln_bayes_factor(s, model, noise), {}, s.information};
  suspect.information.diagonal().array() += std::pow(std::max(1.0, linear_estimate(s, model, noise).scale), -2);
  suspect.value = suspect.information.llt().solve(s.gradient);
  return suspect;
}

}  // namespace

std::vector<Suspect> list_suspects(const Candidates& candidates, const WhitenedModel& model,
                                   const NoiseKnowledge& noise) {
  std::vector<Suspect> all;
  std::size_t effects = 0;
  for (std::size_t e = 0; e < candidates.effects.size(); ++e) {
    const CandidateEffect& candidate = candidates.effects[e];
    if (begins_at_a_moment(*candidate.effect)) continue;
    ++effects;
    std::vector<Suspect> places;
    for (const CandidateUnit& unit : candidate.units) places.push_back(make_suspect(e, unit, model, noise));
    std::stable_sort(places.begin(), places.end(),
                     [](const Suspect& a, const Suspect& b) { return a.probability > b.probability; });
    const double share = std::log(static_cast<double>(places.size()));
    places.resize(std::min(places.size(), places_of_an_effect));
    for (Suspect& s : places) s.probability -= share;
    all.insert(all.end(), places.begin(), places.end());
  }
  for (Suspect& s : all) s.probability -= std::log(static_cast<double>(effects));
  all.push_back({candidates.effects.size(), 0, 0, 0, Eigen::VectorXd(0), Eigen::MatrixXd(0, 0)});
  double most = 0, sum = 0;
  for (const Suspect& s : all) most = std::max(most, s.probability);
  for (Suspect& s : all) sum += s.probability = std::exp(s.probability - most);
  for (Suspect& s : all) s.probability /= sum;
  return all;
}

}  // namespace handsight
