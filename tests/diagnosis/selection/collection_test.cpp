// SPDX-License-Identifier: Apache-2.0
// What several sessions together show: effects that none of them shows, and what has changed between them.
#include <gtest/gtest.h>

#include "diagnosis/selection/improvement.h"
#include "fixtures/two_arms.h"

namespace handsight {
namespace {

using fixture::offset_of;

SimulationOptions simulation(std::uint64_t seed) {
  SimulationOptions o;
  o.seed = seed;
  o.observations = 40;
  o.noise = 2e-4;
  o.nearest = 0.2;
  o.farthest = 4;
  o.most_turned = 1.5;
  return o;
}

std::vector<std::string> names_of(const Improvement& m) {
  std::vector<std::string> names;
  for (const FittedEffect& e : m.last.model.fit.effects)
    names.push_back(e.term.id + " " + place_name(effect_of(e.term), e.term.joint, m.last.model.session.robot));
  return names;
}

std::vector<JoinedMember> two_days(const std::vector<EffectTerm>& august) {
  return fixture::two_days(fixture::hand_session('l'), simulation(31), {}, august);
}

TEST(ImproveCollection, AJointZeroThatChangedBetweenSessionsIsToldAsThat) {
  const Session like = fixture::hand_session('l');
  const Improvement m = improve(joined(two_days({offset_of(like, "l3", 1.5e-3)}), "days"));
  EXPECT_EQ(names_of(m), (std::vector<std::string>{"joint_offset_changed august l3"}));
  EXPECT_EQ(m.last.verdict, Verdict::adequate);
}

TEST(ImproveCollection, NothingIsFoundWhereNothingIsHidden) {
  const Improvement m = improve(joined(two_days({}), "days"));
  EXPECT_TRUE(names_of(m).empty());
  EXPECT_EQ(m.last.verdict, Verdict::adequate);
}

TEST(ImproveCollection, ASlipIsThatOfItsSession) {
  EffectTerm slip = term_of(*find_effect("mount_slip"), -1);
  slip.values = {2e-3, -1e-3, 1e-3, 1e-3, 0, 2e-3, 58};  // of the 80, of which august has the last 40
  const Improvement m = improve(joined(two_days({slip}), "days"));
  EXPECT_EQ(names_of(m), (std::vector<std::string>{"mount_slip august"}));
}

}  // namespace
}  // namespace handsight
