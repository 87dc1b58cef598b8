// SPDX-License-Identifier: Apache-2.0
#include "readers/robots/lerobot.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "base/text.h"
#include "readers/yaml_text.h"

namespace handsight {
namespace {

constexpr double steps_a_turn = 4096;
constexpr double radians_a_step = 2 * std::numbers::pi / steps_a_turn;
constexpr double degrees_a_step = 360 / (steps_a_turn - 1);  // as LeRobot tells degrees

enum class Unit { percent, steps, degrees };

struct ServoColumn {
  std::size_t at = 0;
  const Servo* servo = nullptr;
};

std::vector<ServoColumn> list_columns(const Table& t, const std::vector<Servo>& servos) {
  std::vector<ServoColumn> all;
  for (std::size_t c = 0; c < t.width(); ++c)
    for (const Servo& s : servos)
      if (t.columns[c].name == s.name || t.columns[c].name == s.name + ".pos") all.push_back({c, &s});
  return all;
}

Unit find_unit(const Table& t, const std::vector<ServoColumn>& columns, bool degrees) {
  double lowest = 0, largest = 0;
  bool is_whole = true;
  for (const ServoColumn& c : columns) {
    degrees = degrees || t.columns[c.at].unit == "deg";
    for (const auto& row : t.rows) {
      lowest = std::min(lowest, row[c.at]);
      largest = std::max(largest, std::abs(row[c.at]));
      is_whole = is_whole && row[c.at] == std::floor(row[c.at]);
    }
  }
  if (degrees) return Unit::degrees;
  if (largest <= 100.5) return Unit::percent;
  return is_whole && lowest >= 0 && largest < steps_a_turn ? Unit::steps : Unit::degrees;
}

/// rad from the middle of the servo's range.
double radians_of(double reported, const Servo& s, Unit unit) {
  if (unit == Unit::degrees) return reported / degrees_a_step * radians_a_step;
  if (unit == Unit::steps) return (reported - 0.5 * (s.lowest + s.highest)) * radians_a_step;
  const double share = s.name.find("gripper") == std::string::npos ? reported / 200 : reported / 100 - 0.5;
  return (s.is_reversed ? -share : share) * (s.highest - s.lowest) * radians_a_step;
}

const char* make_text(Unit unit) {
  return unit == Unit::percent ? "per cent of the servos' ranges (-100 to 100)"
         : unit == Unit::steps ? "steps of the servos (4096 a turn)"
                               : "degrees from the middle of the servos' ranges";
}

}  // namespace

bool is_lerobot_calibration(const YAML::Node& yaml) {
  if (!yaml.IsMap()) return false;
  if (yaml["homing_offset"] && yaml["motor_names"]) return true;
  return yaml.size() > 0 && std::all_of(yaml.begin(), yaml.end(), [](const auto& entry) {
           return entry.second.IsMap() && entry.second["homing_offset"] && entry.second["range_min"];
         });
}

std::vector<Servo> read_lerobot_calibration(const YAML::Node& yaml, const std::string& file) {
  if (yaml["motor_names"])
    throw InputError(message(
        "{}: is of LeRobot's older form, which holds no ranges; `lerobot-calibrate` of a newer one writes them.",
        file));
  std::vector<Servo> servos;
  for (const auto& entry : yaml) {
    const std::string name = entry.first.IsScalar() ? entry.first.Scalar() : "";
    const auto lowest = yaml_number(entry.second, "range_min"), highest = yaml_number(entry.second, "range_max");
    if (name.empty() || !lowest || !highest || !(*highest > *lowest))
      throw InputError(message("{}: servo {} has no range_min below its range_max; expected LeRobot's calibration.",
                               file, in_quotes(name)));
    servos.push_back({name, yaml_number(entry.second, "drive_mode").value_or(0) != 0, *lowest, *highest});
  }
  return servos;
}

void set_radians(Table& table, const std::vector<Servo>& servos, bool degrees, std::vector<Message>& notes) {
  const std::vector<ServoColumn> columns = list_columns(table, servos);
  if (columns.empty()) {
    notes.push_back(
        message("{}: no column has the name of a servo of LeRobot's calibration, which is not used.", table.file));
    return;
  }
  const Unit unit = find_unit(table, columns, degrees);
  for (const ServoColumn& c : columns) {
    table.columns[c.at].unit = "rad";
    for (auto& row : table.rows) row[c.at] = radians_of(row[c.at], *c.servo, unit);
  }
  notes.push_back(
      message("{}: {} columns are read as {}; 0 is the middle of each range: where the robot's URDF has another zero, "
              "joint_offset finds it.",
              table.file, columns.size(), make_text(unit)));
}

}  // namespace handsight
