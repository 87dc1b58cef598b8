// SPDX-License-Identifier: Apache-2.0
#include "base/shown_number.h"

#include <gtest/gtest.h>

#include <limits>

namespace handsight {
namespace {

TEST(ShownNumber, HasSoManyDigitsAndNeverAnExponent) {
  EXPECT_EQ(shown_number(0.0192), "0.019");
  EXPECT_EQ(shown_number(49.03), "49");
  EXPECT_EQ(shown_number(6.84), "6.8");
  EXPECT_EQ(shown_number(9.96), "10") << "rounded it has a digit more";
  EXPECT_EQ(shown_number(0.0996), "0.10");
  EXPECT_EQ(shown_number(1234.5), "1234") << "a whole number keeps its digits";
  EXPECT_EQ(shown_number(-0.5), "-0.50");
  EXPECT_EQ(shown_number(3.86e-3), "0.0039");
  EXPECT_EQ(shown_number(1e-4, 1), "0.0001");
  EXPECT_EQ(shown_number(0), "0");
  EXPECT_EQ(shown_number(std::numeric_limits<double>::quiet_NaN()), "-");
}

}  // namespace
}  // namespace handsight
