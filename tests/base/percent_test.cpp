// SPDX-License-Identifier: Apache-2.0
#include "base/percent.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace handsight {
namespace {

TEST(Percent, IsWholeUntilNearlyEverything) {
  EXPECT_EQ(whole_percent(0), "0");
  EXPECT_EQ(whole_percent(0.004), "0");
  EXPECT_EQ(whole_percent(0.074), "7");
  EXPECT_EQ(whole_percent(0.994), "99");
  EXPECT_EQ(whole_percent(0.996), "99.6");
  EXPECT_EQ(whole_percent(0.9994), "99.9");
  EXPECT_EQ(whole_percent(0.9996), "100");
  EXPECT_EQ(whole_percent(1), "100");
}

TEST(Percent, HasTwoDigitsWhereItIsSmall) {
  EXPECT_EQ(two_digit_percent(0), "0");
  EXPECT_EQ(two_digit_percent(0.00123), "0.12");
  EXPECT_EQ(two_digit_percent(0.053), "5.3");
  EXPECT_EQ(two_digit_percent(0.64), "64");
  EXPECT_EQ(two_digit_percent(0.08), "8");
  EXPECT_EQ(two_digit_percent(0.993), "99");
  EXPECT_EQ(two_digit_percent(0.997), "99.7");
  EXPECT_EQ(two_digit_percent(0.9996), "100");
}

TEST(Percent, HasNoExponentAndSaysAllOnlyOfAll) {
  for (int i = 0; i <= 200000; ++i) {
    const double share = i / 200000.0;
    for (const std::string& text : {whole_percent(share), two_digit_percent(share)}) {
      ASSERT_EQ(text.find_first_not_of("0123456789."), std::string::npos) << text;
      ASSERT_NEAR(std::strtod(text.c_str(), nullptr), 100 * share, 0.51) << text;
      ASSERT_EQ(text == "100", 100 * share >= 99.95) << share;
    }
  }
}

}  // namespace
}  // namespace handsight
