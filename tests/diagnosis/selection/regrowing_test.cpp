// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/selection/regrowing.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "diagnosis/evidence/prior_odds.h"
#include "diagnosis/selection/improvement.h"
#include "diagnosis/simulated_stand.h"
#include "session/session_xml.h"

namespace handsight {
namespace {

const std::vector<EffectTerm>& three_causes() {
  static const std::vector<EffectTerm> hidden{
      {"joint_elasticity", 1, {3e-5}}, {"joint_offset", 3, {4e-3}}, {"payload", -1, {2, 0.05, 0, 0}}};
  return hidden;
}

std::set<std::string> ids(const std::vector<EffectTerm>& terms) {
  std::set<std::string> all;
  for (const EffectTerm& t : terms) all.insert(t.id);
  return all;
}

std::set<std::string> names(const Diagnosis& d) { return ids(d.model_options.estimated); }

ModelWalk walked(const Session& session) {
  ModelWalk walk(session, {});
  walk.begin();
  walk.run();
  return walk;
}

/// Where the walk from `end` stands that was cut short at once, one name left out.
ModelWalk cut_short(const Session& session, const std::string& without, const Diagnosis& end) {
  ImprovementOptions one;
  one.most_models = 1;
  ModelWalk walk(session, one);
  walk.begin_without(without, end);
  walk.run();
  return walk;
}

TEST(Regrowing, WhatIsLeftOutOfARightModelComesBack) {
  const Session s = simulated(three_causes(), 31, 40);
  ModelWalk right = walked(s);
  const Diagnosis& end = right.so_far().last;
  ASSERT_EQ(names(end), ids(three_causes()));
  for (const EffectTerm& cause : three_causes()) {
    ModelWalk other(s, {});
    other.begin_without(cause.id, end);
    EXPECT_FALSE(names(other.so_far().last).contains(cause.id));
    for (const DiagnosisCandidate& c : other.so_far().last.candidates) EXPECT_NE(c.id, cause.id) << "at once";
    other.run();
    EXPECT_EQ(names(other.so_far().last), ids(three_causes())) << "without " << cause.id;
    EXPECT_NEAR(held_out_error(other.so_far().last), held_out_error(end), 1e-3 * held_out_error(end));
  }
}

TEST(Regrowing, GoesOnFromAnEndThatIsClearlyLikelier) {
  const Session s = simulated(three_causes(), 31, 40);
  ModelWalk right = walked(s);
  for (const EffectTerm& cause : three_causes()) {
    ModelWalk walk = cut_short(s, cause.id, right.so_far().last);
    ASSERT_FALSE(names(walk.so_far().last).contains(cause.id));
    const double before = held_out_error(walk.so_far().last);
    ImprovementOptions o;
    o.is_thorough = true;
    int told = 0;
    o.on_step = [&](const ImprovementStep& step) { return ++told > 0 && !step.exchanged.empty(); };
    regrow(s, o, walk);
    const Improvement& m = walk.so_far();
    EXPECT_EQ(names(m.last), ids(three_causes())) << "without " << cause.id;
    EXPECT_LT(held_out_error(m.last), 0.9 * before);
    EXPECT_EQ(m.steps.back().exchanged, std::vector<std::string>{cause.id});
    EXPECT_EQ(told, 1) << "the new end alone, not the models on the way";
    EXPECT_FALSE(m.stopped);
    EXPECT_GT(m.models, 2);
  }
}

/// More rows than the budget of other ends allows: what was given costs nothing of it.
TEST(Regrowing, WhatWasGivenDoesNotDecideWhereTheSearchEnds) {
  const Session s = simulated(three_causes(), 31, 120);
  ModelWalk right = walked(s);
  ImprovementOptions given;
  given.estimated = {{"encoder_eccentricity", 0, {0, 0}}};
  ImprovementOptions one = given;
  one.most_models = 1;
  ModelWalk walk(s, one);
  walk.begin();
  walk.run();
  ASSERT_EQ(names(walk.so_far().last), std::set<std::string>{"encoder_eccentricity"});
  regrow(s, given, walk);
  const Improvement& m = walk.so_far();
  std::set<std::string> all = ids(three_causes());
  all.insert("encoder_eccentricity");
  EXPECT_EQ(names(m.last), all);
  EXPECT_EQ(m.last.model_options.estimated.front().id, "encoder_eccentricity");
  EXPECT_LT(held_out_error(m.last), 1.02 * held_out_error(right.so_far().last));
  EXPECT_GT(m.models, right.so_far().models);
}

TEST(Regrowing, StopsWhereItIsTold) {
  const Session s = simulated(three_causes(), 31, 40);
  ModelWalk right = walked(s);
  ModelWalk walk = cut_short(s, "payload", right.so_far().last);
  ImprovementOptions o;
  o.on_progress = [](double) { return false; };
  regrow(s, o, walk);
  EXPECT_TRUE(walk.so_far().stopped);
  EXPECT_EQ(names(walk.so_far().last), (std::set<std::string>{"joint_elasticity", "joint_offset"}));
}

/// Minutes of a search are not lost to who has seen enough.
TEST(Regrowing, WhatWasFoundUntilItWasStoppedIsKept) {
  const std::vector<EffectTerm> hidden = play_beside_a_tilt();
  const Session s = simulated(hidden, 91009, 80, fixture::seven_axis_session(4));
  ModelWalk walk = walked(s);
  ImprovementOptions o;
  o.is_thorough = true;
  o.most_models = 400;
  o.on_step = [](const ImprovementStep& step) { return step.exchanged.empty(); };
  const ModelChange change = improve_on(s, o, walk.so_far().last);
  EXPECT_TRUE(change.stopped);
  ASSERT_TRUE(change.model);
  EXPECT_EQ(names(*change.model), ids(hidden));
  EXPECT_FALSE(change.steps.empty());
  o.on_step = {};
  o.on_progress = [](double) { return false; };
  EXPECT_FALSE(improve_on(s, o, walk.so_far().last).model) << "nothing was found yet";
}

TEST(Regrowing, SpendsNoMoreModelsThanAreLeft) {
  const Session s = simulated(three_causes(), 31, 40);
  ModelWalk right = walked(s);
  ModelWalk walk = cut_short(s, "payload", right.so_far().last);
  ImprovementOptions o;
  o.is_thorough = true;
  o.most_models = walk.so_far().models;
  regrow(s, o, walk);
  EXPECT_EQ(walk.so_far().models, o.most_models);
  EXPECT_TRUE(walk.so_far().is_budget_spent);
  EXPECT_FALSE(names(walk.so_far().last).contains("payload"));
}

/// What stood for both at first leaves scatter that robots have.
TEST(Regrowing, BeginsAgainWithANameThatSaysLittleAlone) {
  const std::vector<EffectTerm> hidden = play_beside_a_tilt();
  const Session s = simulated(hidden, 91009, 80, fixture::seven_axis_session(4));
  ModelWalk walk = walked(s);
  ASSERT_FALSE(names(walk.so_far().last).contains("base_tilt"));
  ASSERT_EQ(walk.so_far().last.verdict, Verdict::adequate);
  ASSERT_TRUE(walk.so_far().last.repeatability.is_any());
  ImprovementOptions o;
  o.is_thorough = true;
  o.most_models = 400;
  regrow(s, o, walk);
  const Diagnosis& end = walk.so_far().last;
  EXPECT_EQ(names(end), ids(hidden));
  EXPECT_FALSE(end.repeatability.is_any());
  ASSERT_FALSE(walk.certain().names.empty());
  for (const InclusionProbability& n : walk.certain().names) {
    if (n.is_in_model) EXPECT_GT(n.probability, 0.999) << n.id << ", also what the other walk began with";
  }
}

TEST(Regrowing, AsksNothingMoreWhereAllIsExplained) {
  const Session s = simulated(three_causes(), 31, 40);
  ModelWalk walk = walked(s);
  ASSERT_EQ(walk.so_far().last.verdict, Verdict::adequate);
  const int before = walk.so_far().models;
  ImprovementOptions o;
  o.is_thorough = true;
  regrow(s, o, walk);
  EXPECT_EQ(walk.so_far().models, before);
}

/// Two axes and a scan, region by region: a drift passes beside nothing else, and is not needed beside the curves.
TEST(Regrowing, OfAPositionerNoDriftStaysThatPostureExplains) {
  const std::filesystem::path folder = std::filesystem::path(HANDSIGHT_SHARED_DIR) / "real/positioner_even";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not here";
  const Improvement m = improve(read_session(folder));
  for (const EffectTerm& t : m.last.model_options.estimated) EXPECT_FALSE(follows_time(t)) << t.id;
  EXPECT_LT(*m.last.report.held_out.mean_m, 0.16e-3);
}

}  // namespace
}  // namespace handsight
