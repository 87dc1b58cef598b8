// SPDX-License-Identifier: Apache-2.0
// A model in names and numbers becomes the engine's terms, and these the model again.
#include "model/model.h"

#include <gmock/gmock.h>

#include "effects/own_effect.h"
#include "session/session_xml.h"

namespace handsight {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Session sample(const char* name) {
  return read_session(std::string(HANDSIGHT_SOURCE_DIR) + "/sample_sessions/" + name);
}

std::string refusal(const Model& model, const Session& session) {
  try {
    (void)list_terms(model, session);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(Model, IsTheEnginesTerms) {
  const Session session = sample("hidden_1");
  const Model model{{{"joint_offset", session.joints[1], {0.01}, false},
                     {"joint_elasticity", session.joints[2]},
                     {"marker_slip", "marker 1"},
                     {"base_tilt"}}};
  const ModelTerms terms = list_terms(model, session);
  ASSERT_EQ(terms.held.size(), 1U);
  EXPECT_EQ(terms.held[0].id, "joint_offset");
  EXPECT_EQ(terms.held[0].place, find_joint(session.robot, session.joints[1]));
  EXPECT_THAT(terms.held[0].values, ElementsAre(0.01));
  ASSERT_EQ(terms.estimated.size(), 3U);
  EXPECT_EQ(terms.estimated[0].place, find_joint(session.robot, session.joints[2]));
  EXPECT_EQ(terms.estimated[1].place, 1);
  EXPECT_EQ(terms.estimated[2].place, -1);
  for (const EffectTerm& term : terms.estimated) {
    EXPECT_EQ(term.values.size(), term_effect(term).parameters.size()) << term.id;
    for (const double value : term.values) EXPECT_EQ(value, 0) << term.id;
  }
}

TEST(Model, ComesBackFromItsTerms) {
  const Session session = sample("hidden_1");
  Model model{
      {{"joint_offset", session.joints[1], {0.01}, false}, {"base_tilt", "", {1e-3, -2e-3}, true, {true, false}}}};
  const Model back = make_model(list_terms(model, session), session.robot);
  ASSERT_EQ(back.effects.size(), model.effects.size());
  for (std::size_t i = 0; i < back.effects.size(); ++i) {
    EXPECT_EQ(back.effects[i].id, model.effects[i].id);
    EXPECT_EQ(back.effects[i].place, model.effects[i].place);
    EXPECT_EQ(back.effects[i].values, model.effects[i].values);
    EXPECT_EQ(back.effects[i].is_estimated, model.effects[i].is_estimated);
    EXPECT_EQ(back.effects[i].held, model.effects[i].held);
  }
}

TEST(Model, TakesEveryEffectOfTheCatalogueWhereverItMaySit) {
  for (const char* name : {"hidden_1", "hidden_3", "one_camera"}) {
    const Session session = sample(name);
    const Chain chain = make_chain(session);
    const OwnEffects own = list_own_effects(session, chain);
    ModelTerms all;
    std::vector<const Effect*> effects = catalogue_beside(own);
    for (const auto& effect : own) effects.push_back(effect.get());
    for (const Effect* effect : effects)
      if (!effect_places(*effect, chain).empty())
        for (const EffectTerm& term : effect_terms(effect->id, chain, own)) all.estimated.push_back(term);
    ASSERT_GE(all.estimated.size(), 30U);
    const ModelTerms back = list_terms(make_model(all, session.robot), session);
    ASSERT_EQ(back.estimated.size(), all.estimated.size());
    for (std::size_t i = 0; i < back.estimated.size(); ++i) {
      EXPECT_EQ(back.estimated[i].id, all.estimated[i].id);
      EXPECT_EQ(back.estimated[i].place, all.estimated[i].place) << back.estimated[i].id;
    }
  }
}

TEST(Model, KeepsACurveThatTheSessionDoesNotDefine) {
  Session session = sample("hidden_1");
  EffectDefinition curve;
  curve.id = "sag_of_mine";
  curve.title = "A sag";
  curve.parameters = {{"size", "rad", 1e-3}};
  curve.moves = {{"angle", "size*sin(q)"}};
  const auto effect = own_effect(curve, session.robot, *session.rig);
  const ModelTerms terms{{}, {term_of(*effect, find_joint(session.robot, session.joints[0]), effect)}};
  const ModelTerms back = list_terms(make_model(terms, session.robot), session);
  ASSERT_EQ(back.estimated.size(), 1U);
  ASSERT_TRUE(back.estimated[0].own);
  EXPECT_EQ(back.estimated[0].own->definition->moves[0].formula, "size*sin(q)");
  EXPECT_EQ(back.estimated[0].place, terms.estimated[0].place);
}

TEST(Model, RefusesWhatCannotBe) {
  const Session session = sample("hidden_1");
  EXPECT_THAT(refusal({{{"joint_offsets"}}}, session), HasSubstr("not in the catalogue"));
  EXPECT_THAT(refusal({{{"joint_offset", "elbow_9"}}}, session), HasSubstr("no moving joint \"elbow_9\""));
  EXPECT_THAT(refusal({{{"joint_offset", session.joints[0], {1, 2}}}}, session), HasSubstr("has 2 values; expected 1"));
  EXPECT_THAT(refusal({{{"joint_offset", session.joints[0], {std::nan("")}}}}, session),
              HasSubstr("has the value nan"));
  EXPECT_THAT(refusal({{{"marker_slip", "marker 60"}}}, session), HasSubstr("the session has the markers 0 to"));
  EXPECT_THAT(refusal({{{"base_tilt", session.joints[0]}}}, session), HasSubstr("leave its place empty"));
  EXPECT_THAT(refusal({{{"base_tilt", "", {0, 0}, true, {true}}}}, session), HasSubstr("of 1 parameters"));
  EXPECT_THAT(refusal({{{"target_scale"}}}, session), HasSubstr("has no place in this session"));
}

}  // namespace
}  // namespace handsight
