// SPDX-License-Identifier: Apache-2.0
// Costs whose valleys bend: a search follows them in long steps. Where it is not led back to the valley's floor, it
// takes 300 steps and more, 300 and more, and 96; where it learns
// nothing from the steps before, up to 40, 40 and 70.
#include <gtest/gtest.h>

#include "estimation/fit/fit.h"
#include "estimation/solvers/least_squares.h"
#include "fixtures/wrong_starts.h"

namespace handsight {
namespace {

struct Valley {
  double zeros = 0;  // rad: of all joints, this way and that, and as many 3e-3 rad/(N m) of springs
  std::vector<std::string> free;
  int most_steps = 0;
};

SimulationOptions make_simulated_robot(const Valley& v, const Chain& chain) {
  SimulationOptions o;
  o.observations = 60;
  o.seed = 1;
  o.effects = effect_terms("joint_offset", chain);
  double sign = 1;
  for (EffectTerm& t : o.effects) t.values[0] = v.zeros * (sign = -sign);
  for (EffectTerm& t : effect_terms("joint_elasticity", chain)) {
    t.values[0] = 3e-3 * v.zeros;
    o.effects.push_back(t);
  }
  return o;
}

/// From sizes of the other sign, which priors hardly hold.
TEST(BentValley, IsFollowedInLongSteps) {
  const Session like = fixture::stand_session();
  const Chain chain = make_chain(like);
  for (const Valley& v :
       {Valley{0.3, {"joint_offset", "link_geometry"}, 25}, Valley{0.6, {"joint_offset", "link_geometry"}, 25},
        Valley{0.1, {"joint_offset", "link_geometry", "joint_elasticity"}, 55}}) {
    FitOptions options;
    for (const std::string& id : v.free)
      for (EffectTerm& t : effect_terms(id, chain)) options.estimated.push_back(std::move(t));
    const Fit f = fit(simulate_session(like, make_simulated_robot(v, chain)).session, options);
    Problem there = f.problem;
    for (EffectColumn& c : there.columns_of_effects) c.sigma *= 30;
    Unknowns start = estimate(f);
    start.effects *= -1;
    set_effects(there, start.effects);
    const Solution s = solve(there, start, {.most_iterations = 300});
    EXPECT_TRUE(s.converged) << v.zeros;
    EXPECT_LE(s.iterations, v.most_steps) << v.zeros;
    EXPECT_LE(s.normal.cost, f.solution.normal.cost) << v.zeros;  // there its prior is wider
  }
}

/// Joints that are far off, and a model that knows of springs alone: what is left is large, and its second derivatives
/// make the cost bend nearly twice as much as the equations say. With whole steps it took 24, 36 and 19 of them, with
/// a share of each up to 15, 24 and 15.
TEST(BentValley, WhereMuchIsLeftStepsDoNotGoTooFar) {
  const Session like = fixture::tracker_session(1);
  const Chain chain = make_chain(like);
  for (const Valley& v : {Valley{0.2, {"link_elasticity"}, 12}, Valley{0.3, {"link_elasticity"}, 12},
                          Valley{0.1, {"joint_elasticity", "link_elasticity"}, 12}}) {
    FitOptions options;
    for (const std::string& id : v.free)
      for (EffectTerm& t : effect_terms(id, chain)) options.estimated.push_back(std::move(t));
    const Fit f = fit(simulate_session(like, make_simulated_robot(v, chain)).session, options);
    Unknowns start = estimate(f);
    start.effects.setZero();
    const Solution s = solve(f.problem, start, {.most_iterations = 300});
    EXPECT_TRUE(s.converged) << v.zeros;
    EXPECT_LE(s.iterations, v.most_steps) << v.zeros;
  }
}

}  // namespace
}  // namespace handsight
