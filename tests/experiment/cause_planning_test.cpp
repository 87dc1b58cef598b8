// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/planning/cause_planning.h"

#include <gmock/gmock.h>

#include "diagnosis/evidence/noise_model.h"
#include "diagnosis/planning/cause_suspects.h"
#include "fixtures/arms.h"
#include "simulation/simulated_session.h"

namespace handsight {
namespace {

Session measured(const std::string& effect, int observations, std::uint64_t seed) {
  const Session like = fixture::stand_session(3);
  SimulationOptions options;
  options.observations = observations;
  options.seed = seed;
  if (!effect.empty()) add_effect_value(effect, like.robot, options.effects);
  return simulate_session(like, options).session;
}

struct Suspects {
  Candidates candidates;
  std::vector<Suspect> all;
};

Suspects suspects_of(const Session& session) {
  const Fit f = fit(session);
  Suspects s{all_candidates(f.problem), {}};
  const NoiseModel noise = noise_model(f);
  const LinearModel model = linear_model(s.candidates.problem, estimate(f), s.candidates.base_effects, noise.noise);
  s.all = list_suspects(s.candidates, whiten(model, {}, noise.knowledge), noise.knowledge);
  return s;
}

TEST(CauseSuspects, WhatIsHiddenIsLikeliestAndProbabilitiesAreOneTogether) {
  const Suspects s = suspects_of(measured("joint_offset:a3.offset=0.004", 12, 3));
  double sum = 0;
  const Suspect* likeliest = &s.all.front();
  for (const Suspect& a : s.all) {
    sum += a.probability;
    if (a.probability > likeliest->probability) likeliest = &a;
  }
  EXPECT_NEAR(sum, 1, 1e-9);
  ASSERT_GT(likeliest->count, 0);
  const CandidateEffect& effect = s.candidates.effects[likeliest->effect];
  EXPECT_EQ(effect.effect->id, "joint_offset");
  EXPECT_NEAR(likeliest->value[0] * effect.sizes[0], 0.004, 5e-4);
}

TEST(CauseSuspects, WhereNothingIsHiddenNothingIsLikeliest) {
  const Suspects s = suspects_of(measured("", 12, 4));
  ASSERT_EQ(s.all.back().count, 0);
  for (const Suspect& a : s.all) EXPECT_LE(a.probability, s.all.back().probability);
}

/// A pose that says much about the cause moves what the hypotheses predict: with those that were chosen the hidden
/// cause stands out more than with as many that were drawn.
TEST(CausePlanning, ChosenPosesSayMoreAboutTheCauseThanRandomOnes) {
  double by_chosen = 0, by_random = 0;
  for (const std::uint64_t seed : {5, 6, 7}) {
    const Session like = fixture::stand_session(3);
    SimulationOptions options;
    options.observations = 9;
    options.seed = seed;
    add_effect_value("joint_scale:a2.scale=0.0004", like.robot, options.effects);
    const Session random = simulate_session(like, options).session;
    Session start = random;
    start.observations.resize(4);
    PlanOptions plan_options;
    plan_options.count = 5;
    plan_options.pool = 150;
    std::vector<Observation> poses = start.observations;
    for (const Eigen::VectorXd& q : plan_for_causes(start, plan_options)) {
      Observation o = poses.back();
      o.id += 1;
      o.time += 1;
      o.position = q;
      poses.push_back(o);
    }
    ASSERT_EQ(poses.size(), 9u);
    const auto odds = [](const Session& s) {
      const Suspects all = suspects_of(s);
      double of_truth = 0;
      for (const Suspect& a : all.all)
        if (a.count > 0 && all.candidates.effects[a.effect].effect->id == "joint_scale") of_truth += a.probability;
      return std::log(of_truth / std::max(1 - of_truth, 1e-12));
    };
    by_chosen += odds(simulate_at(like, options, poses).session);
    by_random += odds(random);
  }
  EXPECT_GT(by_chosen, by_random);
}

TEST(CausePlanning, PosesAreWithinLimitsAndThoseThatMayBeTaken) {
  const Session session = measured("", 5, 8);
  PlanOptions options;
  options.count = 4;
  options.pool = 100;
  options.may_take = [](const Eigen::VectorXd& q) { return q[0] > 0; };
  const std::vector<Eigen::VectorXd> poses = plan_for_causes(session, options);
  ASSERT_EQ(poses.size(), 4u);
  const Chain chain = make_chain(session);
  for (const Eigen::VectorXd& q : poses) {
    EXPECT_GT(q[0], 0);
    for (Eigen::Index j = 0; j < q.size(); ++j) {
      const Joint& joint = chain.robot.joints[static_cast<std::size_t>(chain.joints[static_cast<std::size_t>(j)])];
      EXPECT_GE(q[j], joint.lower);
      EXPECT_LE(q[j], joint.upper);
    }
  }
  EXPECT_EQ(plan_for_causes(session, options), poses);
}

}  // namespace
}  // namespace handsight
