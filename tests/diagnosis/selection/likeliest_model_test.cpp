// SPDX-License-Identifier: Apache-2.0
// A model's own probabilities may prefer other names than those that came into it first.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "diagnosis/selection/improvement.h"
#include "diagnosis/selection/model_changes.h"
#include "diagnosis/simulated_stand.h"
#include "diagnosis/verdict/diagnosis.h"
#include "fixtures/collection_worlds.h"

namespace handsight {
namespace {

using testing::ElementsAre;

Diagnosis model_with(const Session& session, std::vector<EffectTerm> terms) {
  DiagnosisOptions o;
  o.with_held_out = false;
  o.estimated = std::move(terms);
  return diagnose(session, o);
}

InclusionProbabilities probabilities(const Diagnosis& model) {
  return inclusion_probabilities(model, 0, [] { return true; });
}

const EffectTerm weak_joint{"joint_elasticity", 1, {2e-5}};

TEST(LikeliestModel, ComesInThePlaceOfAnother) {
  const Session session = simulated({weak_joint}, 3);
  const Diagnosis wrong = model_with(session, {{"joint_scale", 1, {0}}});
  const InclusionProbabilities told = probabilities(wrong);
  const auto other = fit_likeliest(wrong, 0, told, [] { return true; });
  ASSERT_TRUE(other);
  EXPECT_THAT(other->gone, ElementsAre("joint_scale"));
  EXPECT_THAT(other->come, ElementsAre("joint_elasticity"));
  EXPECT_GT(other->ln_gained, 0);
  ASSERT_EQ(other->options.estimated.size(), 1U);
  EXPECT_EQ(other->options.estimated[0].place, 1);
}

TEST(LikeliestModel, StaysWhereItIs) {
  const Session session = simulated({weak_joint}, 3);
  const Diagnosis right = model_with(session, {{"joint_elasticity", 1, {0}}});
  EXPECT_FALSE(fit_likeliest(right, 0, probabilities(right), [] { return true; }));
  EXPECT_FALSE(fit_likeliest(right, 0, {}, [] { return true; })) << "nobody has asked how likely it is";
}

TEST(LikeliestModel, HasNoMoreNamesThanThere) {
  const Session session = simulated({weak_joint, {"joint_offset", 2, {2e-3}}}, 4);
  const Diagnosis one = model_with(session, {{"joint_elasticity", 1, {0}}});
  const InclusionProbabilities told = probabilities(one);
  ASSERT_TRUE(told.likeliest);
  EXPECT_LE(told.likeliest->size(), 1U);
}

std::vector<std::string> names_after_improving(const std::string& kind, std::uint64_t seed) {
  const auto& kinds = fixture::world_kinds();
  const auto same = std::find_if(kinds.begin(), kinds.end(), [&](const auto& k) { return k.name == kind; });
  const fixture::World world = fixture::world_of(*same, seed);
  const Improvement m = improve(fixture::joined_world(world.members));
  std::vector<std::string> names;
  for (const FittedEffect& e : m.last.model.fit.effects)
    names.push_back(e.term.id + " " + place_name(term_effect(e.term), e.term.place, m.last.model.session.robot));
  return names;
}

/// Of sessions in which a joint's spring came second to the torsion of the link below it.
TEST(LikeliestModel, IsWhatImproveEndsWith) {
  EXPECT_THAT(names_after_improving("two_hands", 1051), ElementsAre("joint_elasticity torso_2"));
  EXPECT_THAT(names_after_improving("days", 1011), ElementsAre("joint_elasticity torso_2"));
}

/// The torsion of a link has the evidence, by less than springs a little at every joint have over it: it was told as
/// one in eighty, and stayed.
TEST(LikeliestModel, ReckonsWithSmallCauses) {
  EXPECT_THAT(names_after_improving("two_hands", 1005), ElementsAre("joint_elasticity torso_2"));
}

}  // namespace
}  // namespace handsight
