// SPDX-License-Identifier: Apache-2.0
#include "estimation/solvers/normal_equations.h"

#include <gtest/gtest.h>

#include "base/threads.h"
#include "estimation/fit/fit.h"
#include "fixtures/arms.h"

namespace handsight {
namespace {

/// With effects of all kinds: joints, the whole robot's, a marker's, cameras'.
Fit fit_of_many(int observations, bool weighted) {
  SimulationOptions o;
  o.seed = 3;
  o.observations = observations;
  o.effects = {{"joint_elasticity", 1, {1e-4}}};
  FitOptions with;
  with.estimated = {{"joint_elasticity", 1, {0}},
                    {"link_geometry", 2, {0, 0, 0, 0}},
                    {"payload", -1, {0, 0, 0, 0}},
                    {"marker_slip", 1, {0, 0, 0, 12}},
                    {"stereo_rig", -1, {0, 0, 0, 0, 0, 0}}};
  if (weighted) with.loss = Loss::huber;
  return fit(simulate_session(fixture::stand_session(), o).session, with);
}

TEST(NormalEquations, GradientAloneIsThatOfTheWhole) {
  for (const bool weighted : {false, true}) {
    const Fit f = fit_of_many(25, weighted);
    Unknowns off = estimate(f);
    off.markers_in_tcp.front().x() += 1e-3;
    for (const ProblemObservation& o : f.problem.observations) {
      NormalEquations whole(f.problem.columns());
      add_observation(f.problem, o, off, whole);
      EXPECT_LT((compute_gradient(f.problem, o, off) - whole.gradient).cwiseAbs().maxCoeff(),
                1e-12 * whole.gradient.cwiseAbs().maxCoeff());
    }
  }
}

TEST(NormalEquations, OfManyObservationsAreTheSumOfEach) {
  const Fit f = fit_of_many(150, false);
  NormalEquations sum(f.problem.columns());
  for (const ProblemObservation& o : f.problem.observations) add_observation(f.problem, o, estimate(f), sum);
  complete(sum);
  NormalEquations all = normal_equations(f.problem, estimate(f));
  EXPECT_EQ(all.rows, sum.rows);
  EXPECT_NEAR(all.data_cost(), sum.cost, 1e-12 * sum.cost);
  const Eigen::Index markers = f.problem.effect_column();  // no priors there
  EXPECT_TRUE(
      all.information.topLeftCorner(markers, markers).isApprox(sum.information.topLeftCorner(markers, markers), 1e-13));
}

TEST(NormalEquations, AreTheSameBitByBitHoweverManyThreadsThereAre) {
  const Fit f = fit_of_many(150, false);
  most_threads() = 1;
  const NormalEquations alone = normal_equations(f.problem, estimate(f));
  most_threads() = 5;
  const NormalEquations together = normal_equations(f.problem, estimate(f));
  most_threads() = 0;
  EXPECT_TRUE((alone.information.array() == together.information.array()).all());
  EXPECT_TRUE((alone.gradient.array() == together.gradient.array()).all());
  EXPECT_EQ(alone.cost, together.cost);
}

}  // namespace
}  // namespace handsight
