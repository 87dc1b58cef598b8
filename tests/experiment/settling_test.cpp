// SPDX-License-Identifier: Apache-2.0
#include "experiment/loop/settling.h"

#include <gtest/gtest.h>

namespace handsight {
namespace {

Knowledge told(const std::string& id, double odds, std::size_t used = 12) {
  Knowledge known;
  known.used = used;
  known.diagnosis.emplace();
  known.diagnosis->verdict = id.empty() ? Verdict::adequate : Verdict::missing_effect;
  known.settled = SettledCause{id, {}, {}, odds};
  return known;
}

Knowledge follows(double odds, std::size_t used) {
  Knowledge known = told("", odds, used);
  known.diagnosis->verdict = Verdict::unexplained;
  known.settled->follows = "angle of a3";
  return known;
}

TEST(Settling, ANameIsSettledByTheOddsTwiceOrByFiftyTimesTheOddsAtOnce) {
  Settling settling(20);
  EXPECT_FALSE(settling.is_settled_by(told("joint_scale", 100)));
  EXPECT_FALSE(settling.is_settled_by(told("joint_offset", 100))) << "another";
  EXPECT_FALSE(settling.is_settled_by(told("joint_offset", 19)));
  EXPECT_FALSE(settling.is_settled_by(told("joint_offset", 21)));
  EXPECT_TRUE(settling.is_settled_by(told("joint_offset", 21)));
  EXPECT_TRUE(Settling(20).is_settled_by(told("joint_scale", 1001)));
}

TEST(Settling, NothingIsSettledByTwoDiagnosesFromTwentyObservationsOn) {
  Settling settling(20);
  EXPECT_FALSE(settling.is_settled_by(told("", 5, 18)));
  EXPECT_FALSE(settling.is_settled_by(told("", 5, 19)));
  EXPECT_FALSE(settling.is_settled_by(told("", 5, 20)));
  EXPECT_FALSE(settling.is_settled_by(told("", 0.5, 25))) << "a cause is likelier";
  EXPECT_FALSE(settling.is_settled_by(told("", 5, 30)));
  EXPECT_TRUE(settling.is_settled_by(told("", 5, 35)));
}

TEST(Settling, WhatHasNoNameIsSettledByItsOddsTwiceFromTwentyObservationsOn) {
  Settling settling(20);
  EXPECT_FALSE(settling.is_settled_by(follows(1e9, 19)));
  EXPECT_FALSE(settling.is_settled_by(follows(1e9, 20)));
  EXPECT_FALSE(settling.is_settled_by(follows(19, 25)));
  EXPECT_FALSE(settling.is_settled_by(follows(21, 30)));
  EXPECT_FALSE(settling.is_settled_by(told("", 5, 35))) << "another answer";
  EXPECT_FALSE(settling.is_settled_by(follows(1e9, 40)));
  EXPECT_TRUE(settling.is_settled_by(follows(1e9, 45)));
}

TEST(Settling, WhatIsOpenSettlesNothing) {
  Settling settling(20);
  Knowledge open;
  EXPECT_FALSE(settling.is_settled_by(open));
  Knowledge unexplained = told("", 5, 40);
  unexplained.diagnosis->verdict = Verdict::unexplained;
  EXPECT_FALSE(settling.is_settled_by(unexplained));
  EXPECT_FALSE(settling.is_settled_by(unexplained));
}

}  // namespace
}  // namespace handsight
