// SPDX-License-Identifier: Apache-2.0
#include "estimation/start/effect_starts.h"

#include <cmath>
#include <random>
#include <vector>

#include "base/threads.h"

namespace handsight {
namespace {

constexpr int draws = 4;
constexpr double clearly = 1e-6;  // of the cost: less is rounding and the last step

Unknowns drawn(const Problem& problem, const Unknowns& near, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  Unknowns start = near;
  for (Eigen::Index i = 0; i < start.effects.size(); ++i)
    start.effects[i] = problem.columns_of_effects[static_cast<std::size_t>(i)].sigma * normal(random);
  return start;
}

}  // namespace

std::optional<Unknowns> better_effects(const Problem& problem, const Solution& found, const SolveOptions& options) {
  SolveOptions quick = options;
  quick.on_iteration = nullptr;
  quick.least_gain = 1e-4 * found.normal.cost / std::max(found.normal.rows, 1);
  quick.reuse_below = 1e-3;
  std::mt19937_64 random(1);
  std::vector<Unknowns> starts;
  for (int i = 0; i < draws; ++i) starts.push_back(drawn(problem, found.unknowns, random));
  std::vector<Solution> ends(starts.size());
  each_part(draws, true, [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    Problem there = problem;
    set_effects(there, starts[at].effects);
    ends[at] = solve(there, starts[at], quick);
  });
  std::optional<Unknowns> best;
  double least = (1 - clearly) * found.normal.cost;
  for (const Solution& s : ends) {
    if (!s.normal.in_front || !(s.normal.cost < least)) continue;
    least = s.normal.cost;
    best = s.unknowns;
  }
  return best;
}

}  // namespace handsight
