// SPDX-License-Identifier: Apache-2.0
// The moments and forms that effects named by the user are given.
#include <gtest/gtest.h>

#include <cmath>

#include "diagnosis/ranking/refitting.h"
#include "diagnosis/simulated_stand.h"

namespace handsight {
namespace {

double moment_of(const EffectTerm& t) {
  const Effect& effect = term_effect(t);
  for (std::size_t p = 0; p < t.values.size(); ++p)
    if (effect.parameters[p].is_choice) return t.values[p];
  return -1;
}

TEST(BestChoices, EveryMarkersOwnMomentIsFoundHoweverManyThereAre) {
  Session like = like_stand();
  like.marker_count = 40;
  EffectTerm slip = effect_terms("marker_slip", make_chain(like))[7];
  slip.values = {4e-3, 0, 0, 13};
  ASSERT_EQ(moment_of(slip), 13);
  const Session session = simulated({slip}, 3, 24, like);
  const std::vector<EffectTerm> settled = best_choices(session, effect_terms("marker_slip", make_chain(session)));
  ASSERT_EQ(settled.size(), 40u);
  EXPECT_EQ(settled[7].place, slip.place);
  EXPECT_EQ(moment_of(settled[7]), 13);
  for (const EffectTerm& t : settled) EXPECT_GT(moment_of(t), 0) << "marker " << t.place;
}

/// Without an observation after it there is no moment at which a marker could have slipped.
TEST(BestChoices, OfTooFewObservationsOfARobotThatSlidesIsNone) {
  Session like = like_stand();
  const int first = make_chain(like).joints.front();
  like.robot.joints[static_cast<std::size_t>(first)].kind = JointKind::prismatic;
  Session session = simulated({}, 3, 24, like);
  for (const std::size_t left : {2U, 1U}) {
    session.observations.resize(left);
    const std::vector<EffectTerm> asked = effect_terms("marker_slip", make_chain(session));
    const std::vector<EffectTerm> settled = best_choices(session, asked);
    ASSERT_EQ(settled.size(), asked.size());
    for (const EffectTerm& t : settled) EXPECT_TRUE(std::isfinite(moment_of(t)));
  }
}

}  // namespace
}  // namespace handsight
