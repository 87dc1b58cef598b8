// SPDX-License-Identifier: Apache-2.0
// Costs whose valleys bend: a search follows them in long steps. Where it is not led back to the valley's floor, it
// takes 300 steps and more, 300 and more, and 96; where it learns
// nothing from the steps before, up to 40, 40 and 70.
#include <gtest/gtest.h>

#include <set>

#include "estimation/fit/fit.h"
#include "estimation/solvers/least_squares.h"
#include "fixtures/wrong_starts.h"
#include "session/session_xml.h"

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

/// Wide priors and narrow ones in turn, until they are settled: between their answers lies the floor of a bent valley,
/// along which hardly any of the cost is to be gained. Where damped steps alone lead back to it, it takes 824 steps.
TEST(BentValley, ItsFloorIsFollowedWhilePriorsSettle) {
  const std::filesystem::path folder = HANDSIGHT_SHARED_DIR "/real/justin_left_even";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no real measurements on this machine";
  const Session session = read_session(folder);
  FitOptions options;
  const auto add = [&](const char* id, const std::set<std::string>& joints) {
    for (EffectTerm& t : effect_terms(id, make_chain(session)))
      if (t.place < 0 || joints.contains(session.robot.joints[static_cast<std::size_t>(t.place)].name))
        options.estimated.push_back(std::move(t));
  };
  add("link_geometry", {"torso_1", "torso_3", "torso_4", "left_arm_3", "left_arm_6"});
  add("joint_elasticity", {"torso_2", "torso_3", "torso_4", "left_arm_1", "left_arm_2", "left_arm_3", "left_arm_4"});
  add("link_elasticity", {"torso_1", "torso_2", "torso_3", "left_arm_2", "left_arm_4"});
  add("base_elasticity", {});
  add("mimic_linkage", {"torso_4"});
  int steps = 0;
  options.on_iteration = [&](int, double, const Unknowns&) { return ++steps > 0; };
  const Fit f = fit(session, options);
  EXPECT_TRUE(f.converged());
  EXPECT_LE(steps, 400);
  EXPECT_LE(f.solution.normal.cost, 0.0034949);  // m^2
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
