// SPDX-License-Identifier: Apache-2.0
#include "effects/formula.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "base/threads.h"

namespace handsight {
namespace {

TEST(Formula, IsRightFromManyThreadsAtOnce) {
  const Formula formula("a * sin(q) + q ^ 2", {"a", "q"}, "here");
  const Formula constant("2 * pi", {}, "there");
  most_threads() = 12;  // more than have a parser each
  std::array<int, 12> wrong{};
  each_part(12, true, [&](int part) {
    for (int i = 0; i < 3000; ++i) {
      const std::array<double, 2> x{0.1 * part, 1e-3 * i};
      const bool is_right = std::abs(formula.value(x) - (x[0] * std::sin(x[1]) + x[1] * x[1])) < 1e-12 &&
                            std::abs(constant.value({}) - 2 * M_PI) < 1e-12;
      wrong[static_cast<std::size_t>(part)] += is_right ? 0 : 1;
    }
  });
  most_threads() = 0;
  EXPECT_EQ(wrong, (std::array<int, 12>{}));
}

}  // namespace
}  // namespace handsight
