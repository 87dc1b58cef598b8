// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/selection/fuller_models.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "diagnosis/selection/diagnosed_model.h"
#include "diagnosis/selection/elsewhere.h"
#include "diagnosis/simulated_stand.h"
#include "diagnosis/verdict/stand_in.h"

namespace handsight {
namespace {

/// Three joints are springs, and one seems to push back.
const std::vector<EffectTerm> springs = {
    {"joint_elasticity", 1, {4e-4}}, {"joint_elasticity", 2, {5e-4}}, {"joint_elasticity", 3, {-1.5e-3}}};

Diagnosis diagnosis_of(const Session& session, std::vector<EffectTerm> terms) {
  for (EffectTerm& t : terms) std::fill(t.values.begin(), t.values.end(), 0.0);
  Diagnosis d = diagnosed_from(session, {}, terms, {});
  set_errors_elsewhere(d);
  return d;
}

std::vector<int> places_of(const std::string& id, const Diagnosis& model) {
  std::vector<int> places;
  for (const EffectTerm& t : model.model_options.estimated)
    if (t.id == id) places.push_back(t.place);
  std::sort(places.begin(), places.end());
  return places;
}

TEST(FullerModel, PlacesThatWereMissedComeAtOnce) {
  const Session session = simulated(springs, 6, 80);
  const Diagnosis wrong = diagnosis_of(session, {springs[2]});
  ASSERT_FALSE(stand_ins(wrong.model.fit).empty());
  const ModelChange change = seek_fuller_model(session, {}, wrong, {});
  ASSERT_TRUE(change.model);
  EXPECT_THAT(places_of("joint_elasticity", *change.model), testing::ElementsAre(1, 2, 3));
  EXPECT_LT(held_out_error(*change.model), 0.9 * held_out_error(wrong));
  EXPECT_EQ(change.models, 1);
  ASSERT_EQ(change.steps.size(), 1U);
  EXPECT_EQ(change.steps[0].removed, "");
}

TEST(FullerModel, NamesThatMayBeThereComeToo) {
  const std::vector<EffectTerm> hidden = {springs[0], springs[2], {"joint_offset", 2, {4e-3}}};
  const Session session = simulated(hidden, 6, 80);
  InclusionProbabilities certainty;
  certainty.names = {{"joint_offset", {}, 0.3}};
  const ModelChange change = seek_fuller_model(session, {}, diagnosis_of(session, {springs[2]}), certainty);
  ASSERT_TRUE(change.model);
  EXPECT_THAT(places_of("joint_elasticity", *change.model), testing::ElementsAre(1, 3));
  EXPECT_THAT(places_of("joint_offset", *change.model), testing::ElementsAre(2));
  EXPECT_THAT(change.steps.at(0).exchanged, testing::ElementsAre("joint_offset"));
}

TEST(FullerModel, IsNotSoughtWhereNothingStandsIn) {
  const Session session = simulated({springs[0], springs[1]}, 5, 80);
  EXPECT_FALSE(seek_fuller_model(session, {}, diagnosis_of(session, {springs[0]}), {}).model);
}

TEST(FullerModel, RightOnesStay) {
  const Session session = simulated(springs, 7, 80);
  EXPECT_FALSE(seek_fuller_model(session, {}, diagnosis_of(session, springs), {}).model);
}

}  // namespace
}  // namespace handsight
