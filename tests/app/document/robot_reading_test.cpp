// SPDX-License-Identifier: Apache-2.0
#include "document/robot_reading.h"

#include <gtest/gtest.h>

#include <cmath>

#include "document/document.h"
#include "temporary_folder.h"

namespace handsight::app {
namespace {

TEST(RobotReading, IsTypedWithWhatItMayBeOffBy) {
  const auto plain = parse_reading(" 1.3 ");
  ASSERT_TRUE(plain);
  EXPECT_DOUBLE_EQ(plain->value, 1.3);
  EXPECT_NEAR(plain->sigma, 0.1 / std::sqrt(12), 1e-12) << "rounded to its last digit";
  for (const char* text : {"1.3 ± 0.05", "1.3 +- 0.05", "1.3+/-0.05", "1.3±0.05"}) {
    const auto both = parse_reading(QString::fromUtf8(text));
    ASSERT_TRUE(both) << text;
    EXPECT_DOUBLE_EQ(both->value, 1.3);
    EXPECT_DOUBLE_EQ(both->sigma, 0.05);
  }
  EXPECT_DOUBLE_EQ(parse_reading(QString::fromUtf8("−2"))->value, -2) << "a true minus, as the window writes it";
  EXPECT_DOUBLE_EQ(parse_reading("1,35")->value, 1.35);
  EXPECT_NEAR(parse_reading("12")->sigma, 1 / std::sqrt(12), 1e-12);
  EXPECT_NEAR(parse_reading("1.20e-3")->sigma, 1e-5 / std::sqrt(12), 1e-15);
  for (const char* text : {"", "one", "1.3 ± ", "1.3 ± -1", "1 ± 2 ± 3", "nan", "1,300", "1.3,5"})
    EXPECT_FALSE(parse_reading(QString::fromUtf8(text))) << text;
}

class RobotReadingOfASession : public testing::Test {
 protected:
  RobotReadingOfASession() {
    session = folder.path / "session";
    std::filesystem::copy(std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions" / "thesis_simulation",
                          session, std::filesystem::copy_options::recursive);
  }
  static RobotReading reading(double value) {
    return {
        "joint_elasticity", value, 1e-4, {"Hang 1 kg on the hand: it should sag", "further", 1.4e-3, 2e-4, "m", 37}};
  }
  TemporaryFolder folder;
  std::filesystem::path session;
};

TEST_F(RobotReadingOfASession, IsRememberedUndoneAndForgotten) {
  {
    Document document;
    document.open(session);
    document.perform(document.edit_of_reading("joint_elasticity", reading(1.3e-3)));
    document.perform(document.edit_of_reading("joint_elasticity", reading(1.1e-3)));
    EXPECT_TRUE(document.edit_of_reading("joint_elasticity", reading(1.1e-3)).is_empty());
    document.undo();
  }
  {
    Document document;
    document.open(session);
    ASSERT_NE(document.find_reading("joint_elasticity"), nullptr);
    EXPECT_EQ(*document.find_reading("joint_elasticity"), reading(1.3e-3)) << "bit for bit";
    document.redo();
    EXPECT_EQ(document.find_reading("joint_elasticity")->value, 1.1e-3);
    document.perform(document.edit_of_reading("joint_elasticity", std::nullopt));
    EXPECT_EQ(document.find_reading("joint_elasticity"), nullptr);
    document.undo_all();
    EXPECT_TRUE(document.readings().empty());
    EXPECT_TRUE(document.is_saved());
  }
}

TEST_F(RobotReadingOfASession, LeavesTheModelAsItIs) {
  Document document;
  document.open(session);
  const auto made =
      make_version(document.session(), document.settings(), document.revision(), QString(), document.second_looks());
  document.take_version(made);
  document.perform(document.edit_of_reading("joint_elasticity", reading(1.3e-3)));
  EXPECT_EQ(document.model(), made);
  EXPECT_EQ(document.versions().back(), nullptr) << "and is no step of its own";
  document.undo();
  EXPECT_EQ(document.model(), made);
}

}  // namespace
}  // namespace handsight::app
