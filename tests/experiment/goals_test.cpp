// SPDX-License-Identifier: Apache-2.0
#include "experiment/loop/goals.h"

#include <gmock/gmock.h>

#include "base/error.h"

namespace handsight {
namespace {

TEST(Goals, SeveralStandInOneText) {
  Goals goals;
  add_goals("hand=0.3mm|odds=20,count=60", goals);
  add_goals("time=1.5h", goals);
  EXPECT_DOUBLE_EQ(*goals.hand, 3e-4);
  EXPECT_EQ(goals.odds, 20);
  EXPECT_EQ(goals.count, 60);
  EXPECT_EQ(goals.seconds, 5400);
}

TEST(Goals, UnitsAreSaid) {
  for (const auto& [text, length] : {std::pair{"hand=300um", 3e-4}, {"hand=0.03cm", 3e-4}, {"hand=3e-4m", 3e-4}}) {
    Goals goals;
    add_goals(text, goals);
    EXPECT_NEAR(*goals.hand, length, 1e-18) << text;
  }
}

TEST(Goals, WhatIsNotUnderstoodIsRefusedWithWhatMayStandThere) {
  for (const char* text : {"", "hand", "hand=", "hand=0.3", "hand=-1mm", "hand=mm", "odds=1", "odds=x", "count=0",
                           "count=1.5", "time=3", "time=3d", "speed=4", "odds=20|"}) {
    Goals goals;
    try {
      add_goals(text, goals);
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("hand=0.3mm")) << text;
    }
  }
}

}  // namespace
}  // namespace handsight
