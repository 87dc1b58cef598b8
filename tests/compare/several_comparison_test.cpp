// SPDX-License-Identifier: Apache-2.0
#include "compare/several_comparison.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.h"
#include "compare/comparison.h"
#include "fixtures/random_robot.h"
#include "fixtures/two_arms.h"
#include "simulation/simulated_session.h"

namespace handsight {
namespace {

using testing::ElementsAre;
using Titles = std::vector<std::string>;

/// Days of one robot with the same cameras and body, each with its own effects.
std::vector<JoinedMember> days(std::uint64_t seed, const std::vector<std::vector<std::string>>& effects) {
  const Session like = fixture::seen_random_session(seed);
  constexpr int each = 50;
  std::vector<JoinedMember> members;
  for (std::size_t k = 0; k < effects.size(); ++k) {
    SimulationOptions o;
    o.observations = each * static_cast<int>(effects.size());
    o.seed = seed;
    o.noise = 0.2;
    o.farthest = 3;
    o.declare_noise = false;
    for (const std::string& text : effects[k]) add_effect_value(text, like.robot, o.effects);
    JoinedMember& m = members.emplace_back();
    m.session = simulate_session(like, o).session;
    m.title = std::string("day ") + static_cast<char>('1' + k);
    m.rig = "cameras";
    m.body = "tool";
    auto& all = m.session.observations;
    const auto first = static_cast<std::ptrdiff_t>(k) * each;
    all.erase(all.begin() + first + each, all.end());
    all.erase(all.begin(), all.begin() + first);
  }
  return members;
}

TEST(SeveralComparison, ATurnOfTheCameraIsToldBetweenTheSessions) {
  const std::string turn = "camera_mount:rx=0.002";
  const SeveralComparison c = compare(days(31, {{}, {turn}, {turn}}));
  ASSERT_EQ(c.verdict, ComparisonVerdict::changed) << c.sentence;
  const ChangeBetween& b = c.changes.front();
  EXPECT_EQ(b.reported.id, "camera_mount");
  EXPECT_THAT(b.reported.before, ElementsAre("day 1"));
  EXPECT_THAT(b.reported.after, ElementsAre("day 2", "day 3"));
  EXPECT_GT(b.reported.probability, 0.95);
  EXPECT_NEAR(b.change.terms.front().values[3], 0.002, 4 * b.change.sigma[3]);
  EXPECT_LT(b.change.sigma[3], 5e-4);
  EXPECT_NE(c.sentence.find("between day 1 and day 2, day 3"), std::string::npos) << c.sentence;
  for (const SharedThing& s : c.shared) EXPECT_LT(s.probability_changed, 0.5) << s.id;
}

TEST(SeveralComparison, OneDayAloneIsToldAsThat) {
  const std::string joint = fixture::seen_random_session(32).joints.at(2);
  const SeveralComparison c = compare(days(32, {{}, {"joint_offset:" + joint + ".offset=0.003"}, {}}));
  ASSERT_EQ(c.verdict, ComparisonVerdict::changed) << c.sentence;
  EXPECT_EQ(c.changes.front().reported.id, "joint_offset");
  EXPECT_EQ(c.changes.front().reported.where, joint);
  EXPECT_THAT(c.changes.front().reported.before, ElementsAre("day 1", "day 3"));
  EXPECT_THAT(c.changes.front().reported.after, ElementsAre("day 2"));
  EXPECT_NEAR(c.changes.front().change.terms.front().values[0], 0.003, 4 * c.changes.front().change.sigma[0]);
}

TEST(SeveralComparison, TwoChangesAreToldEach) {
  const std::string turn = "camera_mount:ry=0.004", joint = fixture::seen_random_session(33).joints.at(1);
  const std::string zero = "joint_offset:" + joint + ".offset=0.004";
  const SeveralComparison c = compare(days(33, {{}, {turn}, {turn, zero}}));
  ASSERT_EQ(c.verdict, ComparisonVerdict::several) << c.sentence;
  ASSERT_EQ(c.changes.size(), 2u) << c.sentence;
  const auto of = [&](const std::string& id) -> const ChangeBetween* {
    const auto found =
        std::find_if(c.changes.begin(), c.changes.end(), [&](const auto& b) { return b.reported.id == id; });
    return found == c.changes.end() ? nullptr : &*found;
  };
  ASSERT_TRUE(of("camera_mount") && of("joint_offset")) << c.sentence;
  EXPECT_THAT(of("camera_mount")->reported.after, ElementsAre("day 2", "day 3"));
  EXPECT_THAT(of("joint_offset")->reported.after, ElementsAre("day 3"));
}

TEST(SeveralComparison, NothingIsToldWhereNothingHasChanged) {
  const std::string joint = fixture::seen_random_session(31).joints.at(1);
  for (const auto& lacking : {std::vector<std::string>{}, {"joint_elasticity:" + joint + ".compliance=1.5e-4"}}) {
    const SeveralComparison c = compare(days(31, {lacking, lacking, lacking}));
    EXPECT_EQ(c.verdict, ComparisonVerdict::unchanged) << c.sentence;
    EXPECT_EQ(c.model_fits, lacking.empty());
  }
}

TEST(SeveralComparison, OfTwoItSaysWhatTheComparisonOfTwoSays) {
  const std::vector<JoinedMember> two = days(34, {{}, {"body_slip:x=0.002"}});
  const Comparison pair = compare(two[0].session, two[1].session);
  const SeveralComparison several = compare(two);
  ASSERT_EQ(several.verdict, ComparisonVerdict::changed) << several.sentence;
  ASSERT_EQ(pair.verdict, ComparisonVerdict::changed) << pair.sentence;
  EXPECT_EQ(several.changes.front().reported.id, pair.changes.front().id);
  EXPECT_NEAR(several.changes.front().change.terms.front().values[0], pair.changes.front().terms.front().values[0],
              0.1 * pair.changes.front().sigma[0]);
  EXPECT_NEAR(several.threshold, pair.threshold, 1e-6);
}

/// Mounts and markers of each day are its own: only what belongs to the robot is asked.
TEST(SeveralComparison, AJointIsComparedThroughOtherMountsAndMarkers) {
  const Session like = fixture::hand_session('l');
  std::vector<JoinedMember> members;
  for (int k = 0; k < 3; ++k) {
    SimulationOptions o;
    o.seed = 70 + static_cast<std::uint64_t>(k);  // other markers
    o.observations = 40;
    o.noise = 2e-4;
    o.nearest = 0.2;
    o.farthest = 4;
    o.most_turned = 1.5;
    if (k == 2) o.effects = {fixture::find_offset(like, "l3", 2e-3)};
    members.push_back(fixture::simulated_member(like, o, std::string("day ") + static_cast<char>('1' + k)));
  }
  const SeveralComparison c = compare(members);
  ASSERT_EQ(c.verdict, ComparisonVerdict::changed) << c.sentence;
  EXPECT_EQ(c.changes.front().reported.id, "joint_offset");
  EXPECT_EQ(c.changes.front().reported.where, "l3");
  EXPECT_THAT(c.changes.front().reported.after, ElementsAre("day 3"));
  EXPECT_NEAR(c.changes.front().change.terms.front().values[0], 2e-3, 4 * c.changes.front().change.sigma[0]);
  EXPECT_EQ(c.rigs.size(), 3u);
  for (const SharedThing& s : c.shared) EXPECT_NE(s.id, "camera_mount") << "each has its own";
}

TEST(SeveralComparison, OthersAreRefusedByName) {
  std::vector<JoinedMember> members = days(34, {{}, {}});
  EXPECT_THROW(compare({members.front()}), InputError);
  members[1].session.tcp = "elsewhere";
  try {
    compare(members);
    FAIL() << "compared";
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("day 1 and day 2 cannot be compared: their TCPs are other links"),
              std::string::npos)
        << e.what();
  }
}

}  // namespace
}  // namespace handsight
