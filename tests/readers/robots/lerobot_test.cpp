// SPDX-License-Identifier: Apache-2.0
// What LeRobot's servos tell, by their calibration.
#include "readers/robots/lerobot.h"

#include <gmock/gmock.h>

#include <numbers>

#include "readers/yaml_text.h"
#include "session/session_texts.h"

namespace handsight {
namespace {

using testing::Contains;
using testing::HasSubstr;

const std::string calibration =
    "{\"shoulder_pan\": {\"id\": 1, \"drive_mode\": 0, \"homing_offset\": -1470, \"range_min\": 1000, \"range_max\": "
    "3048},"
    " \"elbow\": {\"id\": 2, \"drive_mode\": 1, \"homing_offset\": 0, \"range_min\": 0, \"range_max\": 4096},"
    " \"gripper\": {\"id\": 6, \"drive_mode\": 0, \"homing_offset\": 0, \"range_min\": 2048, \"range_max\": 3072}}";

std::vector<double> radians(const std::string& rows, bool degrees, std::vector<Message>& notes) {
  const auto servos = read_lerobot_calibration(parse_yaml(calibration, "arm.json"), "arm.json");
  Table table = *parse_table("shoulder_pan.pos,elbow.pos,gripper.pos\n" + rows, "joints.csv");
  set_radians(table, servos, degrees, notes);
  for (const TableColumn& c : table.columns) EXPECT_EQ(c.unit, "rad");
  return table.rows.at(0);
}

TEST(Lerobot, PerCentDegreesAndStepsAreTheSameAngles) {
  constexpr double quarter = std::numbers::pi / 2;
  std::vector<Message> notes;
  // Half a turn of range: 100 % is a quarter turn. The elbow counts the other way, a whole turn of range.
  const auto percent = radians("100,50,100\n-100,0,0\n", false, notes);
  EXPECT_NEAR(percent[0], quarter, 1e-12);
  EXPECT_NEAR(percent[1], -quarter, 1e-12);
  EXPECT_NEAR(percent[2], quarter / 2, 1e-12);
  EXPECT_THAT(notes, Contains(HasSubstr("3 columns are read as per cent")));
  const auto steps = radians("3048,1024,3072\n2024,2048,2560\n", false, notes);
  EXPECT_NEAR(steps[0], quarter, 1e-12);
  EXPECT_NEAR(steps[1], -quarter, 1e-12);
  EXPECT_NEAR(steps[2], quarter / 2, 1e-12);
  const auto degrees = radians("90,-90,45\n0,0,0\n", true, notes);
  for (const std::size_t i : {0u, 1u, 2u})
    EXPECT_NEAR(degrees[i], percent[i], 4e-4) << "LeRobot counts 4095 steps a turn";
}

TEST(Lerobot, WhatIsNoCalibrationIsRefused) {
  EXPECT_TRUE(is_lerobot_calibration(parse_yaml(calibration, "a")));
  EXPECT_FALSE(is_lerobot_calibration(parse_yaml("{\"a\": 1}", "a")));
  const std::string older = "{\"homing_offset\": [1], \"drive_mode\": [0], \"motor_names\": [\"a\"]}";
  EXPECT_THAT(find_refusal([&] { read_lerobot_calibration(parse_yaml(older, "a"), "arm.json"); }),
              HasSubstr("lerobot-calibrate"));
  const std::string wrong = "{\"a\": {\"homing_offset\": 1, \"range_min\": 5, \"range_max\": 5}}";
  EXPECT_THAT(find_refusal([&] { read_lerobot_calibration(parse_yaml(wrong, "a"), "arm.json"); }),
              HasSubstr("range_min"));
}

}  // namespace
}  // namespace handsight
