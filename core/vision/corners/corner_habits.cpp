// SPDX-License-Identifier: Apache-2.0
#include "vision/corners/corner_habits.h"

#include <algorithm>
#include <cmath>

namespace handsight {
namespace {

constexpr double kToldAdded = 0.1;   // grey levels per px: where a corner's own is known as well, all of it counts
constexpr double kPlainAdded = 0.2;  // grey levels per px, of all corners together: there is glare
constexpr double kFewCorners = 4;    // that the usual bend counts as; fewer tell nothing of the noise
constexpr double kFewPixels = 400;   // that white noise counts as
constexpr double kLargeDisc = 200;   // pixels: on smaller ones the next cells make neighbours alike
constexpr double kSmallDiscs = 0.5;  // of what seems alike on them is the noise's doing
constexpr double kMostAlike = 0.1;   // of neighbouring pixels: what interpolates colours makes edges look bent
constexpr double kPlainBend = 5e-4;  // 1/px, of all corners together: the lens bends edges
// Of what fits leave, that differs at opposite points: where it is less the next cells reach into the discs, and what
// they pull at looks like bends.
constexpr double kLeastOdd = 0.4;
constexpr double kLeastChequer = 0.1, kSureChequer = 4;  // the latter in standard errors
constexpr double kLeastFactor = 0.7, kMostFactor = 12;

}  // namespace

Habits habits_of(std::span<const OddSystem> systems) {
  Habits habits;
  double bends = kFewCorners * kBendSigma * kBendSigma, corners = kFewCorners, pixels = kFewPixels;
  double added = 0, lit = kFewCorners;
  double ratios = 0, chequer = 0, chequer_squares = 0;
  int looked_at = 0;
  const bool has_large = std::count_if(systems.begin(), systems.end(), [](const OddSystem& s) {
                           return s.weights > kLargeDisc && s.influence[0] != 0;
                         }) >= kFewCorners;
  for (const OddSystem& system : systems) {
    for (int i = 4; i < 6; ++i) {
      const double own = system.seen_variance[i], trust = 1 / (1 + own / (kToldAdded * kToldAdded));
      added += 0.5 * trust * (system.seen[i] * system.seen[i] - own), lit += 0.5 * trust;
    }
    for (int i = 6; i < 8; ++i) {
      const double own = system.seen_variance[i], trust = 1 / (1 + own / 1e-6);
      bends += 0.5 * trust * (system.seen[i] * system.seen[i] - own), corners += 0.5 * trust;
    }
    if (system.influence[0] == 0) continue;
    const double pixels_of = has_large && system.weights < kLargeDisc ? 0 : system.weights;
    pixels += pixels_of, ++looked_at;
    ratios += system.variance_ratio;
    chequer += system.chequer, chequer_squares += system.chequer * system.chequer;
    for (int k = 0; k < kNeighbours; ++k) {
      habits.correlation[k] += pixels_of * system.products[k];
      habits.influence[k] += system.influence[k];
    }
  }
  if (looked_at > 0) habits.variance = ratios / looked_at;
  if (looked_at > 2) {
    const double mean = chequer / looked_at, variance = chequer_squares / looked_at - mean * mean;
    const double error = std::sqrt(std::max(variance, 1e-6) / (looked_at - 1));
    habits.is_mosaic = std::abs(mean) > kLeastChequer && std::abs(mean) > kSureChequer * error;
  }
  for (float& influence : habits.influence) influence /= static_cast<float>(std::max(looked_at, 1));
  habits.added = std::max(std::sqrt(std::max(added, 0.0) / lit), kAddedSigma);
  habits.bend = std::clamp(std::sqrt(std::max(bends, 0.0) / corners), 0.3 * kBendSigma, kMostBend);
  if (habits.variance < kLeastOdd) habits.bend = std::min(habits.bend, kPlainBend);
  const bool all_small = !has_large && looked_at >= kFewCorners;
  for (double& correlation : habits.correlation) correlation *= (all_small ? kSmallDiscs : 1) / pixels;
  return habits;
}

double correlation_factor(const OddSystem& system, const Habits& habits) {
  if (system.is_smoothed) return 1;
  const auto& influence = system.influence[0] != 0 ? system.influence : habits.influence;
  double factor = 1;
  for (int k = 0; k < kNeighbours; ++k) factor += 2 * habits.correlation[k] * influence[k];
  return std::clamp(factor, kLeastFactor, kMostFactor);
}

bool are_bent(const Habits& habits) {
  const auto most = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const double alike = *std::max_element(habits.correlation.begin(), habits.correlation.end(), most);
  return habits.bend > kPlainBend && habits.variance > kLeastOdd && std::abs(alike) < kMostAlike;
}

bool are_glared(const Habits& habits) { return habits.added > kPlainAdded; }

}  // namespace handsight
