// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/evidence/threshold.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "diagnosis/evidence/prior_odds.h"

namespace handsight {
namespace {

constexpr int draws = 400;
constexpr double false_alarms = 0.005;
constexpr double least_threshold = 4;
constexpr auto& scales = prior_scales;

/// Normal numbers by Marsaglia's polar method. std::normal_distribution draws the same, but works out how many bits its
/// generator has at every number, which takes longer than the number.
class NormalNumbers {
 public:
  explicit NormalNumbers(std::mt19937_64& random) : random_(random) {}

  double next() {
    if (has_other_) {
      has_other_ = false;
      return other_;
    }
    double x = 0, y = 0, square = 0;
    do {
      x = between_minus_one_and_one();
      y = between_minus_one_and_one();
      square = x * x + y * y;
    } while (square > 1 || square == 0);
    const double times = std::sqrt(-2 * std::log(square) / square);
    other_ = x * times;
    has_other_ = true;
    return y * times;
  }

 private:
  double between_minus_one_and_one() { return 2 * (static_cast<double>(random_()) * 0x1p-64) - 1; }

  std::mt19937_64& random_;
  double other_ = 0;
  bool has_other_ = false;
};

/// One choice of places: under noise alone its score has independent normal components with these variances.
struct NullScore {
  std::vector<std::array<double, scales.size()>> gained;  // per component: s^2 l / (1 + s^2 l) / 2
  std::array<double, scales.size()> volume{};             // ln det(I + s^2 A) / 2

  explicit NullScore(const Score& s) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(s.information, Eigen::EigenvaluesOnly);
    for (const double l : eigen.eigenvalues()) {
      if (l <= 1e-6) continue;
      auto& of_this = gained.emplace_back();
      for (std::size_t i = 0; i < scales.size(); ++i) {
        const double s2l = scales[i] * scales[i] * l;
        volume[i] += 0.5 * std::log1p(s2l);
        of_this[i] = 0.5 * s2l / (1 + s2l);
      }
    }
  }

  double draw(std::mt19937_64& random) const {
    std::array<double, scales.size()> factors{};
    NormalNumbers normal(random);
    for (const auto& of_this : gained) {
      const double z = normal.next(), z2 = z * z;
      for (std::size_t i = 0; i < scales.size(); ++i) factors[i] += z2 * of_this[i];
    }
    for (std::size_t i = 0; i < scales.size(); ++i) factors[i] -= volume[i];
    return ln_over_scales(factors);
  }
};

/// The classes of one effect's choices: alternatives alone, or single joints and all of them.
std::vector<std::vector<NullScore>> null_scores(const WhitenedModel& w, const CandidateEffect& c) {
  std::vector<std::vector<NullScore>> classes(1);
  for (const CandidateUnit& unit : c.units) classes[0].emplace_back(score(w, unit.first, unit.count));
  const auto is_choice = [](const EffectParameter& p) { return p.is_choice; };
  const bool has_choices = std::any_of(c.effect->parameters.begin(), c.effect->parameters.end(), is_choice);
  if (!moves_one_joint(*c.effect) || c.units.size() < 2 || has_choices) return classes;
  const Eigen::Index first = c.units.front().first;
  classes.emplace_back();
  classes[1].emplace_back(score(w, first, c.units.back().first + c.units.back().count - first));
  return classes;
}

}  // namespace

double simulated_threshold(const LinearModel& model, const Candidates& candidates, const Repeatability& repeatability,
                           const NoiseKnowledge& knowledge) {
  const WhitenedModel w = whiten(model, repeatability, knowledge);
  std::vector<std::vector<std::vector<NullScore>>> effects;
  std::vector<double> odds;  // ln of those against each
  for (const CandidateEffect& c : candidates.effects) {
    effects.push_back(null_scores(w, c));
    odds.push_back(c.units.empty() ? 0 : ln_odds_against(c.units.front().term));
  }
  std::mt19937_64 random(20261121);
  std::vector<double> largest;
  for (int i = 0; i < draws; ++i) {
    double best = -1e300;
    for (std::size_t e = 0; e < effects.size(); ++e) {
      const auto& classes = effects[e];
      std::vector<double> means;
      for (const std::vector<NullScore>& scores : classes) {
        std::vector<double> factors;
        factors.reserve(scores.size());
        for (const NullScore& s : scores) factors.push_back(s.draw(random));
        means.push_back(ln_mean_exp(factors));
      }
      best = std::max(best, ln_mean_exp(means) - odds[e]);
    }
    largest.push_back(best);
  }
  std::sort(largest.begin(), largest.end());
  const std::size_t tail = largest.size() * 9 / 10;
  double excess = 0;
  for (std::size_t i = tail; i < largest.size(); ++i)
    excess += (largest[i] - largest[tail]) / static_cast<double>(largest.size() - tail);
  const double quantile = largest[tail] + excess * std::log(0.1 / false_alarms);
  return std::max(quantile, least_threshold) + (repeatability.is_any() ? more_with_repeatability : 0);
}

}  // namespace handsight
