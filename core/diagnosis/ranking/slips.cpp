// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/ranking/slips.h"

#include <algorithm>
#include <cmath>

#include "estimation/report/fit_report.h"

namespace handsight {
namespace {

constexpr int most_blocks = 10;
constexpr double least_sigmas = 2.3;  // of the sum of what all observations gain

}  // namespace

bool slip_is_confirmed(const Session& session, const Fit& without, const FitOptions& without_options, const Fit& with,
                       const FitOptions& with_options, double order) {
  const auto count = static_cast<int>(without.problem.observations.size());
  const int blocks = std::min(most_blocks, count / 3);
  if (blocks < 3) return true;  // too few to ask
  const std::vector<double> before = held_out_in_blocks(session, without, without_options, blocks);
  const std::vector<double> after = held_out_in_blocks(session, with, with_options, blocks);
  if (before.size() != after.size() || static_cast<int>(before.size()) != count) return true;
  // By the gains' own spread: nothing is taken for normal, and a few observations with much to gain prove little.
  double earlier = 0, later = 0, squares = 0;
  for (int i = 0; i < count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double gain = before[at] - after[at];
    const auto index = static_cast<std::size_t>(without.problem.observations[at].index);
    (without.problem.source->states[index].order < order ? earlier : later) += gain;
    squares += gain * gain;
  }
  return earlier > 0 && later > 0 && earlier + later > least_sigmas * std::sqrt(squares);
}

}  // namespace handsight
