// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/selection/likeliest_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace handsight {
namespace {

constexpr double least_of_likeliest = 0.05;  // of the likeliest: small causes take no more from a name
constexpr std::size_t most_choices = 12;     // choices

Chosen with_all(Chosen chosen, const Chosen& further) {
  for (const std::size_t u : further) chosen = with_unit(chosen, u);
  return chosen;
}

/// Of no more units than the model has, the likeliest by evidence first.
std::vector<std::pair<double, Chosen>> likely_choices(const ModelSpace& all, const OpenUnits& units,
                                                      const Weights& weights) {
  const auto present = static_cast<std::size_t>(
      std::count_if(units.open.begin(), units.open.end(), [&](std::size_t u) { return all.units()[u].is_present; }));
  std::vector<std::pair<double, Chosen>> choices;
  for (const auto& [chosen, weight] : weights)
    if (chosen.size() <= present) choices.emplace_back(weight, with_all(units.fixed, chosen));
  std::stable_sort(choices.begin(), choices.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  return choices;
}

}  // namespace

LikeliestChoice likeliest_choice(const ModelSpace& all, const OpenUnits& units, const Weights& weights,
                                 const std::vector<SmallCauses>& of_model) {
  const std::vector<std::pair<double, Chosen>> choices = likely_choices(all, units, weights);
  const Chosen model = all.present();
  const double standing_of_model = ln_standing(of_model);
  LikeliestChoice likeliest{units.fixed};
  double best = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < std::min(most_choices, choices.size()); ++i) {
    const auto& [weight, chosen] = choices[i];
    if (weight < least_of_likeliest * choices.front().first) break;
    const double standing = chosen == model ? standing_of_model : ln_standing(find_small_causes(all, chosen));
    if (std::log(weight) + standing <= best) continue;
    best = std::log(weight) + standing;
    likeliest = {chosen, standing - standing_of_model};
  }
  return likeliest;
}

}  // namespace handsight
