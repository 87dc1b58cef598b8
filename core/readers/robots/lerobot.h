// SPDX-License-Identifier: Apache-2.0
// LeRobot's calibrations of servos (JSON: id, drive_mode, homing_offset, range_min, range_max of each).
#pragma once

#include <yaml-cpp/yaml.h>

#include <string>
#include <vector>

#include "base/message.h"
#include "readers/table.h"

namespace handsight {

struct Servo {
  std::string name;
  bool is_reversed = false;        // drive_mode 1: its readings in per cent count the other way
  double lowest = 0, highest = 0;  // steps of 4096 a turn
};

bool is_lerobot_calibration(const YAML::Node& yaml);

/// InputError where a number is missing, or the file is of the older form without ranges.
std::vector<Servo> read_lerobot_calibration(const YAML::Node& yaml, const std::string& file);

/// Columns of these servos ("shoulder_pan", "shoulder_pan.pos") in rad from the middle of their range: from per cent of
/// the range (-100 to 100, of a gripper 0 to 100), from steps, or from degrees where `degrees` or the header says so.
/// Sentences in `notes`.
void set_radians(Table& table, const std::vector<Servo>& servos, bool degrees, std::vector<Message>& notes);

}  // namespace handsight
