// SPDX-License-Identifier: Apache-2.0
#include "base/letters.h"

#include <gtest/gtest.h>

#include "base/median.h"

namespace handsight {
namespace {

TEST(Letters, CapitalsBecomeSmallAndAllElseStays) {
  EXPECT_EQ(lower_case("IMG_01.JPG"), "img_01.jpg");
  EXPECT_EQ(lower_case("Gr\xC3\x9C\xC3\x9F"
                       "E"),
            "gr\xC3\x9C\xC3\x9F"
            "e");
  EXPECT_EQ(lower_case(""), "");
}

TEST(Letters, WhatStandsAroundATextIsTakenOff) {
  EXPECT_EQ(trimmed(" \tq1 deg\r"), "q1 deg");
  EXPECT_EQ(trimmed("q1"), "q1");
  EXPECT_EQ(trimmed(" \t "), "");
  EXPECT_EQ(trimmed(""), "");
  EXPECT_EQ(trimmed(" \"x\" ", " \""), "x");
}

TEST(Median, IsTheUpperOfTwo) {
  EXPECT_EQ(median({3, 1, 2}), 2);
  EXPECT_EQ(median({4, 1, 3, 2}), 3);
  EXPECT_EQ(median({7}), 7);
  EXPECT_EQ(median({}), 0);
}

}  // namespace
}  // namespace handsight
