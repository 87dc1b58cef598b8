// SPDX-License-Identifier: Apache-2.0
#include "base/combinations.h"

#include <gtest/gtest.h>

namespace handsight {
namespace {

TEST(Combinations, AreThoseOfPascalsTriangle) {
  double row[31] = {1};
  for (int n = 1; n <= 30; ++n) {
    for (int k = n; k > 0; --k) row[k] += row[k - 1];
    for (int k = 0; k <= n; ++k) EXPECT_NEAR(ln_choose(n, k), std::log(row[k]), 1e-12) << n << " " << k;
  }
  EXPECT_EQ(ln_choose(0, 0), 0);
}

}  // namespace
}  // namespace handsight
