// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/selection/model_search.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "diagnosis/selection/model_changes.h"
#include "diagnosis/simulated_stand.h"
#include "diagnosis/verdict/diagnosis.h"

namespace handsight {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Two wrong zeros and a mount that is off: what the geometry of all joints can nearly imitate.
const std::vector<EffectTerm> hidden = {{"camera_mount", -1, {2e-3, -4e-3, 3e-3, 6e-3, -3e-3, -5e-3}},
                                        {"joint_offset", 1, {-4e-3}},
                                        {"joint_offset", 2, {3e-3}}};

Diagnosis with(const Session& session, std::vector<EffectTerm> terms) {
  for (EffectTerm& t : terms) std::fill(t.values.begin(), t.values.end(), 0.0);
  DiagnosisOptions o;
  o.with_held_out = false;
  o.estimated = std::move(terms);
  return diagnose(session, o);
}

std::optional<ModelAlternative> all_names(const Diagnosis& model, bool goes_on = true) {
  return search_models(model, 0, [=] { return goes_on; });
}

TEST(ModelAlternative, SeveralComeForOneThatStoodInForThem) {
  const Session session = simulated(hidden, 5, 80);
  const auto other = all_names(with(session, effect_terms("link_geometry", make_chain(session))));
  ASSERT_TRUE(other);
  EXPECT_THAT(other->gone, ElementsAre("link_geometry"));
  EXPECT_THAT(other->come, ElementsAre("camera_mount", "joint_offset"));
  const std::vector<EffectTerm>& found = other->options.estimated;
  ASSERT_EQ(found.size(), hidden.size());
  for (const EffectTerm& truth : hidden) {
    const auto same = std::find_if(found.begin(), found.end(),
                                   [&](const EffectTerm& t) { return t.id == truth.id && t.place == truth.place; });
    ASSERT_NE(same, found.end()) << truth.id << ' ' << truth.place;
    for (std::size_t p = 0; p < truth.values.size(); ++p) EXPECT_NEAR(same->values[p], truth.values[p], 6e-4) << p;
  }
}

TEST(ModelAlternative, RightOnesStayWhereTheyAre) { EXPECT_FALSE(all_names(with(simulated(hidden, 6, 80), hidden))); }

TEST(ModelAlternative, PlacesThatSayNothingGoAndTheNameStays) {
  const std::vector<EffectTerm> one = {{"link_geometry", 2, {9e-4, -6e-4, 3e-3, -2.5e-3}}};
  const Session session = simulated(one, 7);
  const auto other = all_names(with(session, effect_terms("link_geometry", make_chain(session))));
  ASSERT_TRUE(other);
  EXPECT_THAT(other->gone, IsEmpty());
  EXPECT_THAT(other->come, IsEmpty());
  ASSERT_EQ(other->options.estimated.size(), 1U);
  EXPECT_EQ(other->options.estimated[0].place, 2);
}

TEST(ModelAlternative, WhatTheUserPutThereStays) {
  const Session session = simulated(hidden, 5, 80);
  std::vector<EffectTerm> terms = effect_terms("joint_scale", make_chain(session));
  const std::size_t own = terms.size();
  for (const EffectTerm& t : effect_terms("link_geometry", make_chain(session))) terms.push_back(t);
  const auto other = search_models(with(session, terms), own, [] { return true; });
  ASSERT_TRUE(other);
  for (std::size_t t = 0; t < own; ++t) {
    EXPECT_EQ(other->options.estimated[t].id, "joint_scale");
    EXPECT_EQ(other->options.estimated[t].place, terms[t].place);
  }
}

TEST(ModelAlternative, SayNothingOnceTheyAreStopped) {
  const Session session = simulated(hidden, 5, 80);
  EXPECT_FALSE(all_names(with(session, effect_terms("link_geometry", make_chain(session))), false));
}

TEST(ModelAlternative, AreAStepOfTheirOwn) {
  const Session session = simulated(hidden, 5, 80);
  ImprovementOptions o;
  o.with_held_out = false;
  const Diagnosis wrong = with(session, effect_terms("link_geometry", make_chain(session)));
  const ModelChange change = search_models(session, o, wrong);
  ASSERT_TRUE(change.model);
  ASSERT_EQ(change.steps.size(), 1U);
  EXPECT_EQ(change.steps[0].added, "");
  EXPECT_EQ(change.steps[0].removed, "link_geometry");
  EXPECT_THAT(change.steps[0].exchanged, ElementsAre("camera_mount", "joint_offset"));
  EXPECT_LE(held_out_error(*change.model), held_out_error(wrong));
  EXPECT_FALSE(search_models(session, o, *change.model).model) << "they would change for ever";
}

}  // namespace
}  // namespace handsight
