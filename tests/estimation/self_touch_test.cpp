// SPDX-License-Identifier: Apache-2.0
// Self touch: what is touched is fixed to a link of the same robot, of the same arm or of the other one.
#include <gmock/gmock.h>

#include "diagnosis/selection/improvement.h"
#include "estimation/fit/fit.h"
#include "estimation/fit/touch_unknown.h"
#include "fixtures/touch_session.h"
#include "fixtures/two_arms.h"

namespace handsight {
namespace {

struct OnLink {
  const FixtureKind* kind;
  const char *id, *link;
  Vector3 place;
};

/// The right hand's probe; all joints of both arms and of the torso are read.
Session probe_of_right_hand(const std::vector<OnLink>& fixtures) {
  Session s = fixture::hand_session('r', 1);
  s.observations.clear();
  s.sigma_point = 2e-5;
  for (int i = 1; i <= 6; ++i) s.joints.push_back("l" + std::to_string(i));
  for (const OnLink& f : fixtures) {
    fixture::add_fixture(s, f.kind, f.id, f.place);
    (s.fixtures.size() == 1 ? s.mount : s.other_mounts.back()).link = f.link;
  }
  return s;
}

const OnLink on_ball{&fixtures::point, "ball", "left_hand", {0.12, 0, 0.03}};
const OnLink on_ball_2{&fixtures::point, "ball_2", "left_hand", {0.05, 0.06, 0.05}};
const OnLink on_plate{&fixtures::plane, "plate", "l4_link", {0, 0, 0.06}};
const OnLink on_socket{&fixtures::point, "socket", "chest", {0.4, -0.1, 0.2}};
const OnLink on_own{&fixtures::point, "own", "r1_link", {0.55, -0.2, -0.3}};

void expect_named(const std::vector<OnLink>& fixtures, const char* joint) {
  const Session like = probe_of_right_hand(fixtures);
  const Session s = fixture::simulated_touches(like, 90, 5, {fixture::find_offset(like, joint, 3e-3)}).session;
  const Improvement m = improve(s);
  ASSERT_EQ(m.last.model.fit.effects.size(), 1U) << joint;
  const FittedEffect& found = m.last.model.fit.effects.front();
  EXPECT_EQ(found.term.id, "joint_offset");
  EXPECT_EQ(found.term.place, find_joint(s.robot, joint));
  EXPECT_NEAR(found.term.values[0], 3e-3, 4 * found.sigmas[0]);
}

TEST(SelfTouch, AJointOfEitherArmIsNamed) {
  expect_named({on_ball}, "l3");
  expect_named({on_ball, on_ball_2}, "r4");
  expect_named({on_ball, on_plate, on_socket}, "l3");
}

TEST(SelfTouch, TheArmTouchesALinkOfItsOwn) { expect_named({on_own, on_socket}, "r3"); }

/// The last joint before the ball turns the ball about its own axis, as another place of it would.
TEST(SelfTouch, ZerosThatCannotBeKnownAreNamedOnBothSides) {
  const Session s = fixture::simulated_touches(probe_of_right_hand({on_ball}), 90, 5).session;
  std::string said;
  for (const Message& text : touch_unknown_texts(s, fit(s, {}))) said += text.english() + "\n";
  EXPECT_THAT(said, testing::ContainsRegex("The zero of torso_1, torso_2,? .*l6.* cannot be known"));
  EXPECT_THAT(said, testing::ContainsRegex("r6"));
}

}  // namespace
}  // namespace handsight
