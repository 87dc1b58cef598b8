// SPDX-License-Identifier: Apache-2.0
// The moments and forms that effects named by the user are given.
#include <gtest/gtest.h>

#include "diagnosis/refitting.h"
#include "simulated_stand.h"

namespace handsight {
namespace {

double moment_of(const EffectTerm& t) {
  const Effect& effect = effect_of(t);
  for (std::size_t p = 0; p < t.values.size(); ++p)
    if (effect.parameters[p].is_choice) return t.values[p];
  return -1;
}

TEST(BestChoices, EveryMarkersOwnMomentIsFoundHoweverManyThereAre) {
  Session like = like_stand();
  like.marker_count = 40;
  EffectTerm slip = effect_terms("marker_slip", chain_of(like))[7];
  slip.values = {4e-3, 0, 0, 13};
  ASSERT_EQ(moment_of(slip), 13);
  const Session session = simulated({slip}, 3, 24, like);
  const std::vector<EffectTerm> settled = best_choices(session, effect_terms("marker_slip", chain_of(session)));
  ASSERT_EQ(settled.size(), 40u);
  EXPECT_EQ(settled[7].joint, slip.joint);
  EXPECT_EQ(moment_of(settled[7]), 13);
  for (const EffectTerm& t : settled) EXPECT_GT(moment_of(t), 0) << "marker " << t.joint;
}

}  // namespace
}  // namespace handsight
