// SPDX-License-Identifier: Apache-2.0
#include "estimation/solvers/incremental_fit.h"

#include <gtest/gtest.h>

#include "estimation/fit/fit.h"
#include "fixtures/arms.h"

namespace handsight {
namespace {

TEST(IncrementalFit, WhatIsNoLongerKeptStillCounts) {
  SimulationOptions options;
  options.observations = 60;
  options.seed = 8;
  const Session session = simulate_session(fixture::tracker_session(3), options).session;
  const Fit all = fit(session);
  const Problem& problem = all.problem;
  // The same observations again and again: the answer stays, the information grows with their number.
  constexpr std::size_t rounds = IncrementalFit::most_kept / 60 + 20;
  IncrementalFit running(problem, estimate(all), 2);
  for (std::size_t round = 0; round < rounds; ++round)
    for (const ProblemObservation& o : problem.observations) running.add(o);
  EXPECT_EQ(running.size(), 60 * rounds);
  EXPECT_GT(running.size(), IncrementalFit::most_kept);
  EXPECT_EQ(running.rows(), static_cast<int>(rounds) * 60 * 9);
  for (std::size_t m = 0; m < 3; ++m)
    EXPECT_LT((running.unknowns().markers_in_tcp[m] - estimate(all).markers_in_tcp[m]).norm(), 1e-8);  // m
  // A part in a thousand: the cost is that at the places of linearisation, the first of which lie off by the noise.
  EXPECT_NEAR(running.cost(), static_cast<double>(rounds) * all.solution.normal.data_cost(), 1e-3 * running.cost());
}

}  // namespace
}  // namespace handsight
