// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/evidence/threshold.h"

#include <gtest/gtest.h>

#include <random>

#include "diagnosis/ranking/ranking.h"
#include "diagnosis/simulated_stand.h"
#include "diagnosis/verdict/diagnosis.h"
#include "effects/own_effect.h"
#include "estimation/fit/fit.h"

namespace handsight {
namespace {

/// A tracker that sees one marker: every row is external, so that noise can be drawn anew into the model.
struct NoiseAlone {
  Candidates candidates;
  LinearModel model;

  NoiseAlone() {
    const Session session = simulated({}, 11, 40, fixture::tracker_session(1));
    const Fit f = fit(session, {});
    candidates = all_candidates(f.problem);
    model = linear_model(candidates.problem, estimate(f), candidates.base_effects, 2e-4);
  }
};

TEST(Threshold, IsReachedByNoiseAloneInOneSessionOfTwoHundred) {
  NoiseAlone n;
  const double threshold = simulated_threshold(n.model, n.candidates, {}, {});
  EXPECT_GE(threshold, 4);
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  constexpr int draws = 400;
  int reached = 0, halfway = 0;
  for (int i = 0; i < draws; ++i) {
    for (Eigen::Index r = 0; r < n.model.external_error.size(); ++r) n.model.external_error[r] = normal(random);
    const Ranking ranking = rank(n.model, {}, n.candidates, {});
    reached += ranking.effects.front().ln_bayes_factor >= threshold;
    halfway += ranking.effects.front().ln_bayes_factor >= 0;
  }
  // 2 expected; a hundredth of a hundredth of such trials have more than 9.
  EXPECT_LE(reached, 9);
  EXPECT_GT(halfway, reached) << "the draws are no constant";
}

TEST(Threshold, AsksForMoreWhereRepeatabilityIsEstimatedToo) {
  const NoiseAlone n;
  EXPECT_GT(simulated_threshold(n.model, n.candidates, {1e-4, 0}, {}),
            simulated_threshold(n.model, n.candidates, {}, {}));
}

/// A hidden offset, and joints that do not repeat better than 0.2 mrad.
Session restless() {
  Session session = simulated({{"joint_offset", 2, {0.02}}}, 17, 80);
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  for (Observation& o : session.observations)
    for (double& q : o.position) q += 2e-4 * normal(random);
  return session;
}

EffectTerm small_curve(const Session& session) {
  EffectDefinition d;
  d.id = "curve_1";
  d.unnamed = true;
  d.scope = "session";
  d.parameters = {{"size", "m", 1e-3}};
  d.moves = {{"hand_x", "size*sin(3*q_a2)", 0}};
  const auto effect = own_effect(d, session.robot);
  return term_of(*effect, -1, effect);
}

TEST(Threshold, OfTheNextNameIsEasedByNamesThatHaveComeInAndNotByCurves) {
  const Session session = restless();
  DiagnosisOptions o;
  o.with_held_out = false;
  const EffectTerm offset{"joint_offset", 2, {0}};
  o.estimated = {offset};
  const Diagnosis named = diagnose(session, o);
  o.estimated = {offset, small_curve(session)};
  const Diagnosis with_curve = diagnose(session, o);
  ASSERT_TRUE(named.repeatability.is_any());
  ASSERT_TRUE(with_curve.repeatability.is_any());
  EXPECT_GE(named.threshold, 4);
  EXPECT_LT(named.threshold, 6.5);
  EXPECT_GE(with_curve.threshold, 6.5);
}

}  // namespace
}  // namespace handsight
