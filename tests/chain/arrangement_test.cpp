// SPDX-License-Identifier: Apache-2.0
#include "chain/arrangement.h"

#include <gmock/gmock.h>

#include "fixtures/targets.h"

namespace handsight {
namespace {

using testing::HasSubstr;

TEST(Arrangement, SaysWhoCarriesWhat) {
  const Session stand = fixture::target_session();
  EXPECT_EQ(find_arrangement(make_chain(stand)), Arrangement::sensor_stands);
  EXPECT_EQ(arrangement_sentence(stand, make_chain(stand)),
            "The camera on stand sees a board that the robot moves on hand.");
  const Session hand = fixture::eye_in_hand_session(fixture::tags());
  EXPECT_EQ(find_arrangement(make_chain(hand)), Arrangement::sensor_on_hand);
  EXPECT_EQ(arrangement_sentence(hand, make_chain(hand)), "The robot moves the camera on hand over tags on stand.");
}

TEST(Arrangement, CamerasOnALinkBetweenAreMovedWithTheTarget) {
  Session s = fixture::target_session(fixture::charuco(), 2);
  s.mount.link = "l2";
  EXPECT_EQ(find_arrangement(make_chain(s)), Arrangement::sensor_stands) << "the joints between are the hand's alone";
}

TEST(Arrangement, NothingThatMovesIsSaid) {
  Session s = fixture::target_session();
  s.tcp = "stand";
  EXPECT_EQ(find_arrangement(make_chain(s)), Arrangement::nothing_moves);
  EXPECT_THAT(arrangement_sentence(s, make_chain(s)), HasSubstr("No measured joint"));
  for (const Arrangement a :
       {Arrangement::sensor_stands, Arrangement::sensor_on_hand, Arrangement::both_move, Arrangement::nothing_moves})
    EXPECT_GT(advice_on(a).size(), 20u);
}

}  // namespace
}  // namespace handsight
