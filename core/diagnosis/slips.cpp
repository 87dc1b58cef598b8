// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/slips.h"

#include <algorithm>
#include <cmath>

namespace handsight {
namespace {

constexpr int most_blocks = 10;
constexpr double ln_20 = 2.995732273553991;
constexpr double tails = 4;  // degrees of freedom of Student's distribution

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// ln of the density of a mean square, about `usual`, up to a constant. One observation counts as one number: its
/// coordinates share one error of the pose.
double ln_density(double mean_square, double usual) {
  return -(tails + 1) / 2 * std::log1p(mean_square / usual / tails);
}

}  // namespace

std::optional<double> slip_order(const std::vector<EffectTerm>& terms) {
  for (const EffectTerm& term : terms) {
    const Effect& effect = effect_of(term);
    for (std::size_t p = 0; p < effect.parameters.size(); ++p)
      if (effect.parameters[p].is_choice && effect.parameters[p].choices.empty()) return term.values[p];
  }
  return std::nullopt;
}

bool slip_is_confirmed(const Session& session, const Fit& without, const FitOptions& without_options, const Fit& with,
                       const FitOptions& with_options, double order) {
  const auto count = static_cast<int>(without.problem.observations.size());
  const int blocks = std::min(most_blocks, count / 3);
  if (blocks < 3) return true;  // too few to ask
  const std::vector<double> before = held_out_in_blocks(session, without, without_options, blocks);
  const std::vector<double> after = held_out_in_blocks(session, with, with_options, blocks);
  if (before.size() != after.size() || static_cast<int>(before.size()) != count) return true;
  const double usual = std::max(median_of(after), 1e-300);
  double earlier = 0, later = 0;
  for (int i = 0; i < count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double gain = ln_density(after[at], usual) - ln_density(before[at], usual);
    const auto index = static_cast<std::size_t>(without.problem.observations[at].index);
    (without.problem.source->circumstances[index].order < order ? earlier : later) += gain;
  }
  return earlier + later > ln_20 && earlier > 0 && later > 0;
}

}  // namespace handsight
