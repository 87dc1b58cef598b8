// SPDX-License-Identifier: Apache-2.0
#include "effects/rig_effects.h"

#include <gtest/gtest.h>

#include "effects/own_effect.h"
#include "fixtures/rigs.h"

namespace handsight {
namespace {

const Effect& effect_in(const OwnEffects& own, const std::string& id) { return *find_effect(id, own); }

TEST(RigEffects, OfLeftAndRightAreThoseOfTheCatalogue) {
  const Session s = fixture::stand_session();
  EXPECT_TRUE(rig_effects(*s.rig).empty());
  const Effect &intrinsics = *find_effect("camera_intrinsics"), &lens = *find_effect("lens_distortion");
  std::vector<std::string> names;
  for (const Effect* e : {&intrinsics, &lens})
    for (const EffectParameter& p : e->parameters) names.push_back(p.name + " " + p.unit);
  EXPECT_EQ(names, (std::vector<std::string>{"left_fx px", "left_fy px", "left_cx px", "left_cy px", "right_fx px",
                                             "right_fy px", "right_cx px", "right_cy px", "left_k1 1", "left_k2 1",
                                             "left_p1 1", "left_p2 1", "right_k1 1", "right_k2 1", "right_p1 1",
                                             "right_p2 1"}));
}

TEST(RigEffects, OfAnotherPairHaveItsNames) {
  const Session s = fixture::rig_session(2);
  const Chain chain = make_chain(s);
  const OwnEffects own = list_own_effects(s, chain);
  const Effect& intrinsics = effect_in(own, "camera_intrinsics");
  EXPECT_EQ(intrinsics.scope, EffectScope::session);
  EXPECT_EQ(intrinsics.parameters[4].name, "cam_1_fx");
  EXPECT_EQ(effect_places(effect_in(own, "stereo_rig"), chain), std::vector<int>{-1});
  EXPECT_TRUE(effect_places(effect_in(own, "rig"), chain).empty());
}

TEST(RigEffects, OfOneCameraAndOfManySitAtEachCamera) {
  for (const int cameras : {1, 3, 8}) {
    const Session s = fixture::rig_session(cameras);
    const Chain chain = make_chain(s);
    const OwnEffects own = list_own_effects(s, chain);
    for (const char* id : {"camera_intrinsics", "lens_distortion"}) {
      const Effect& e = effect_in(own, id);
      EXPECT_EQ(e.parameters.size(), 4u);
      EXPECT_EQ(effect_places(e, chain).size(), static_cast<std::size_t>(cameras)) << id;
    }
    EXPECT_EQ(effect_places(effect_in(own, "rig"), chain).size(), static_cast<std::size_t>(cameras - 1))
        << "the first is the reference";
    EXPECT_TRUE(effect_places(effect_in(own, "stereo_rig"), chain).empty());
  }
}

TEST(RigEffects, MoveTheirOwnCameraAlone) {
  const Session s = fixture::rig_session(3);
  const Chain chain = make_chain(s);
  const OwnEffects own = list_own_effects(s, chain);
  std::vector<EffectTerm> terms;
  for (const char* text : {"rig:cam_2.x=0.001", "camera_intrinsics:cam_1.cx=2", "lens_distortion:cam_0.p2=1e-3"})
    add_effect_value(text, s.robot, terms, own);
  ASSERT_EQ(terms.size(), 3u);
  const Rig moved = moved_rig(*s.rig, moved_sites(states_at(chain, Eigen::VectorXd::Zero(6)), terms));
  EXPECT_EQ(place_name(term_effect(terms[0]), terms[0].place, s.robot), "cam_2");
  EXPECT_NEAR(moved.at(2).camera_from_first.translation.x(), s.rig->at(2).camera_from_first.translation.x() + 1e-3,
              1e-15);
  EXPECT_EQ(moved.at(1).camera_from_first.translation, s.rig->at(1).camera_from_first.translation);
  EXPECT_EQ(moved.at(1).camera.cx, s.rig->at(1).camera.cx + 2);
  EXPECT_EQ(moved.at(2).camera.cx, s.rig->at(2).camera.cx);
  EXPECT_EQ(moved.at(0).camera.p2, s.rig->at(0).camera.p2 + 1e-3);
}

TEST(RigEffects, WhatARigHasNotIsRefusedByName) {
  const auto refusal = [](int cameras, const std::string& text) {
    const Session s = fixture::rig_session(cameras);
    const Chain chain = make_chain(s);
    try {
      effect_terms(text, chain, list_own_effects(s, chain));
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(refusal(1, "stereo_rig").find("has no place in this session"), std::string::npos);
  EXPECT_NE(refusal(1, "rig").find("has no place in this session"), std::string::npos);
  EXPECT_NE(refusal(3, "rig:cam_0").find("it may sit at: cam_1, cam_2"), std::string::npos);
  EXPECT_NE(refusal(3, "camera_intrinsics:left").find("cam_0, cam_1, cam_2"), std::string::npos);
  EXPECT_EQ(refusal(3, "camera_intrinsics:cam_0+cam_2"), "");
}

TEST(RigEffects, OwnFormulasNameTheCamerasOfTheSession) {
  const Session s = fixture::rig_session(3);
  EffectDefinition d;
  d.id = "warm_lens";
  d.scope = "session";
  d.parameters = {{"a", "px", 1}};
  d.moves = {{"cam_2_fx", "a", 0}};
  const auto effect = own_effect(d, s.robot, *s.rig);
  Sites sites;
  const Chain chain = make_chain(s);
  const std::vector<double> three{3.0};
  effect->move(states_at(chain, Eigen::VectorXd::Zero(6)), -1, three, sites);
  EXPECT_EQ(sites.cameras[2].numbers[0], 3);
  d.moves[0].site = "left_fx";
  EXPECT_THROW(own_effect(d, s.robot, *s.rig), InputError);
}

}  // namespace
}  // namespace handsight
