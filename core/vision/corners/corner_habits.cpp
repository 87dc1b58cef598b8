// SPDX-License-Identifier: Apache-2.0
#include "vision/corners/corner_habits.h"

#include <algorithm>
#include <cmath>

#include "vision/corners/corner_odd_system.h"

namespace handsight {
namespace {

constexpr double most_reported_added =
    0.1;                             // grey levels per px: where a corner's own is known as well, all of it counts
constexpr double plain_added = 0.2;  // grey levels per px, of all corners together: there is glare
constexpr double few_corners = 4;    // that the usual bend counts as; fewer tell nothing of the noise
constexpr double few_pixels = 400;   // that white noise counts as
constexpr double large_disc = 200;   // pixels: on smaller ones the next cells make neighbours alike
constexpr double small_discs = 0.5;  // of what seems alike on them is the noise's doing
constexpr double most_alike = 0.1;   // of neighbouring pixels: what interpolates colours makes edges look bent
constexpr double plain_bend = 5e-4;  // 1/px, of all corners together: the lens bends edges
// Of what fits leave, that differs at opposite points: where it is less the next cells reach into the discs, and what
// they pull at looks like bends.
constexpr double least_odd = 0.4;
constexpr double least_chequer = 0.1, sure_chequer = 4;  // the latter in standard errors
constexpr double least_factor = 0.7, most_factor = 12;

}  // namespace

Habits learn_habits(std::span<const OddSystem> systems) {
  Habits habits;
  double bends = few_corners * bend_sigma * bend_sigma, corners = few_corners, pixels = few_pixels;
  double added = 0, lit = few_corners;
  double ratios = 0, chequer = 0, chequer_squares = 0;
  int looked_at = 0;
  const bool has_large = std::count_if(systems.begin(), systems.end(), [](const OddSystem& s) {
                           return s.weights > large_disc && s.influence[0] != 0;
                         }) >= few_corners;
  for (const OddSystem& system : systems) {
    for (int i = 4; i < 6; ++i) {
      const double own = system.seen_variance[i], trust = 1 / (1 + own / (most_reported_added * most_reported_added));
      added += 0.5 * trust * (system.seen[i] * system.seen[i] - own), lit += 0.5 * trust;
    }
    for (int i = 6; i < 8; ++i) {
      const double own = system.seen_variance[i], trust = 1 / (1 + own / 1e-6);
      bends += 0.5 * trust * (system.seen[i] * system.seen[i] - own), corners += 0.5 * trust;
    }
    if (system.influence[0] == 0) continue;
    const double list_pixels = has_large && system.weights < large_disc ? 0 : system.weights;
    pixels += list_pixels, ++looked_at;
    ratios += system.variance_ratio;
    chequer += system.chequer, chequer_squares += system.chequer * system.chequer;
    for (int k = 0; k < neighbour_count; ++k) {
      habits.correlation[k] += list_pixels * system.products[k];
      habits.influence[k] += system.influence[k];
    }
  }
  if (looked_at > 0) habits.variance = ratios / looked_at;
  if (looked_at > 2) {
    const double mean = chequer / looked_at, variance = chequer_squares / looked_at - mean * mean;
    const double error = std::sqrt(std::max(variance, 1e-6) / (looked_at - 1));
    habits.is_mosaic = std::abs(mean) > least_chequer && std::abs(mean) > sure_chequer * error;
  }
  for (float& influence : habits.influence) influence /= static_cast<float>(std::max(looked_at, 1));
  habits.added = std::max(std::sqrt(std::max(added, 0.0) / lit), added_sigma);
  habits.bend = std::clamp(std::sqrt(std::max(bends, 0.0) / corners), 0.3 * bend_sigma, most_bend);
  if (habits.variance < least_odd) habits.bend = std::min(habits.bend, plain_bend);
  const bool all_small = !has_large && looked_at >= few_corners;
  for (double& correlation : habits.correlation) correlation *= (all_small ? small_discs : 1) / pixels;
  return habits;
}

double correlation_factor(const OddSystem& system, const Habits& habits) {
  if (system.is_smoothed) return 1;
  const auto& influence = system.influence[0] != 0 ? system.influence : habits.influence;
  double factor = 1;
  for (int k = 0; k < neighbour_count; ++k) factor += 2 * habits.correlation[k] * influence[k];
  return std::clamp(factor, least_factor, most_factor);
}

bool are_bent(const Habits& habits) {
  const auto most = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const double alike = *std::max_element(habits.correlation.begin(), habits.correlation.end(), most);
  return habits.bend > plain_bend && habits.variance > least_odd && std::abs(alike) < most_alike;
}

bool are_glared(const Habits& habits) { return habits.added > plain_added; }

}  // namespace handsight
