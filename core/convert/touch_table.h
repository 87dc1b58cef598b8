// SPDX-License-Identifier: Apache-2.0
// Tables of touches: a line a touch, with the joints' angles, what was touched and what it read.
#pragma once

#include <filesystem>

#include "base/message.h"
#include "readers/table.h"
#include "robot/robot.h"

namespace handsight {

struct TouchRow {
  std::string fixture;
  Eigen::VectorXd position;     // in the order of TouchTable::joints
  std::optional<double> value;  // m
  std::optional<double> time;   // s
  int marker = 0;               // the tip, where the probe has several
};

struct TouchTable {
  std::vector<std::string> joints;
  std::vector<TouchRow> rows;
  bool are_deviations = false;  // the values are what is off from a length that the fixture's description has
};

/// The text's table; `columns` name those of a table that has no header ("-": left out). Nothing where it is no table.
std::optional<Table> parse_touch_table(const std::string& text, const std::string& file, const Robot* robot,
                                       const std::vector<std::string>& columns);

/// Has it a column that says by its name what was touched?
bool names_fixtures(const Table& table);

/// What was touched, a row each, by that column or by the only one of words; empty: there is none.
std::vector<std::string> list_fixtures(const Table& table);

/// `fixture`: what is touched in a table that has no such column. Lines of the same `pose` in which the robot stood the
/// same are one touch. InputError where a reading has no unit, or a joint is in degrees and nothing says so.
TouchTable read_touch_table(Table table, const Robot& robot, const std::string& fixture, bool degrees,
                            std::vector<Message>& notes);

}  // namespace handsight
