// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/attribution/common.h"

#include <gtest/gtest.h>

namespace handsight {
namespace {

Variable variable(const Message& name, const std::string& unit, const Eigen::VectorXd& values,
                  VariableKind kind = VariableKind::angle) {
  return {kind, 0, name, unit, values};
}

TEST(WhatIsCommon, FindsTheVariableAndItsRange) {
  const int count = 100;
  Eigen::VectorXd angle(count), time(count);
  std::vector<char> chosen(count, 0);
  for (int i = 0; i < count; ++i) {
    angle[i] = std::fmod(0.37 * i, 2.0);
    time[i] = i;
    chosen[static_cast<std::size_t>(i)] = angle[i] > 1.2;
  }
  const std::vector<Variable> variables = {variable("time", "s", time, VariableKind::time),
                                           variable("angle of arm_4", "rad", angle)};
  const std::vector<Common> common = what_is_common(variables, chosen);
  ASSERT_EQ(common.size(), 2u);
  EXPECT_EQ(common[0].variable, 1u);
  EXPECT_DOUBLE_EQ(common[0].parted, 1);
  EXPECT_NEAR(common[0].low, 1.2, 0.03);
  EXPECT_TRUE(std::isinf(common[0].high));
  const std::string text = common_text(common[0], variables[1]);
  EXPECT_NE(text.find("the angle of arm_4 above 1.2"), std::string::npos) << text;
  EXPECT_NE(text.find("rad; of the other"), std::string::npos) << text;
  EXPECT_NE(text.find("none."), std::string::npos) << text;
}

TEST(WhatIsCommon, TakesARangeBetweenTwoValuesAndCountsExceptions) {
  Eigen::VectorXd x(10);
  x << 0, 1, 2, 3, 4, 5, 6, 7, 8, 9;
  const std::vector<char> chosen = {0, 0, 0, 1, 1, 0, 1, 0, 0, 0};
  const std::vector<Common> common = what_is_common({variable("angle of a", "rad", x)}, chosen);
  EXPECT_EQ(common[0].chosen, 3);
  EXPECT_EQ(common[0].others, 1);
  EXPECT_DOUBLE_EQ(common[0].low, 2.5);
  EXPECT_DOUBLE_EQ(common[0].high, 6.5);
  EXPECT_EQ(common_text(common[0], variable("angle of a", "rad", x)),
            "All 3 have the angle of a between 2.5 and 6.5 rad; of the other 7 only 1.");
}

TEST(WhatIsCommon, EqualValuesStayTogetherAndNothingIsSaidOfAll) {
  Eigen::VectorXd x(6);
  x << 1, 1, 1, -1, -1, -1;
  const Variable v = variable("direction in which a last moved", "sign", x, VariableKind::approach);
  const std::vector<Common> common = what_is_common({v}, {1, 1, 0, 0, 0, 0});
  EXPECT_EQ(common[0].others, 1);
  EXPECT_EQ(common_text(common[0], v),
            "All 2 share the direction in which a last moved (positive); of the other 4 only 1.");
  EXPECT_TRUE(what_is_common({v}, {1, 1, 1, 1, 1, 1}).empty());
}

}  // namespace
}  // namespace handsight
