// SPDX-License-Identifier: Apache-2.0
// Models whose cost has more than one valley: the effects' sizes are tried from several starts.
#include "estimation/start/effect_starts.h"

#include <gtest/gtest.h>

#include "estimation/solvers/normal_equations.h"
#include "fixtures/wrong_starts.h"
#include "session/session_xml.h"

namespace handsight {
namespace {

struct Springs {
  Session session;
  Problem problem;
  Solution best;
};

/// Springs that are there, and a model that has them.
Springs springs() {
  SimulationOptions o;
  o.observations = 40;
  Session like = fixture::stand_session();
  const Chain chain = make_chain(like);
  o.effects = effect_terms("joint_elasticity", chain);
  for (EffectTerm& t : o.effects)
    for (double& value : t.values) value = 1e-4;
  Springs s;
  s.session = simulate_session(like, o).session;
  std::vector<EffectTerm> estimated = effect_terms("joint_elasticity", chain);
  const Fit f = fit(s.session, {.estimated = estimated});
  s.problem = f.problem;
  s.best = f.solution;
  return s;
}

TEST(EffectStarts, TheBestMinimumIsNotLeft) {
  const Springs s = springs();
  ASSERT_TRUE(s.best.converged);
  EXPECT_FALSE(better_effects(s.problem, s.best, {.most_iterations = 40}));
}

TEST(EffectStarts, FromAWorseEndABetterIsFound) {
  const Springs s = springs();
  Solution worse = s.best;
  worse.unknowns.effects.array() += 3e-4;
  Problem there = s.problem;
  set_effects(there, worse.unknowns.effects);
  worse.normal = normal_equations(there, worse.unknowns);
  ASSERT_GT(worse.normal.cost, 2 * s.best.normal.cost);
  const auto start = better_effects(there, worse, {.most_iterations = 40});
  ASSERT_TRUE(start);
  set_effects(there, start->effects);
  EXPECT_NEAR(normal_equations(there, *start).cost, s.best.normal.cost, 1e-3 * s.best.normal.cost);
}

/// Geometry, springs and a tendon of a real humanoid at once: from sizes of nothing the search ends in a valley where a
/// seventh more is left than in another.
TEST(EffectStarts, ARealHumanoidsDeepestValley) {
  const std::filesystem::path folder = HANDSIGHT_SHARED_DIR "/real/justin_right_even";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no real measurements on this machine";
  const Session session = read_session(folder);
  std::vector<EffectTerm> estimated;
  for (const char* id :
       {"link_geometry", "joint_elasticity", "link_elasticity", "mimic_linkage", "joint_offset", "base_elasticity"})
    for (EffectTerm& t : effect_terms(id, make_chain(session))) estimated.push_back(std::move(t));
  const Fit f = fit(session, {.estimated = estimated});
  EXPECT_TRUE(f.converged());
  EXPECT_LT(f.residual_rms, 1.70e-3);  // of one coordinate; 1.78e-3 in the other valley
}

}  // namespace
}  // namespace handsight
