// SPDX-License-Identifier: Apache-2.0
#include "convert/touch_table.h"

#include <cmath>

#include "base/error.h"
#include "base/text.h"
#include "readers/pose_files.h"

namespace handsight {
namespace {

constexpr std::initializer_list<const char*> fixture_names{"fixture", "touched"};
constexpr std::initializer_list<const char*> value_names{"value", "reading", "distance", "length", "height", "gauge"};
constexpr std::initializer_list<const char*> marker_names{"marker", "tip", "probe"};
constexpr std::initializer_list<const char*> pose_names{"pose", "pose_id", "poseid", "observation"};

char separator_of(std::string_view line) {
  for (const char c : {';', '\t', ','})
    if (line.find(c) != std::string_view::npos) return c;
  return ' ';
}

/// m of one of the column's unit.
double find_unit(const Table& table, std::size_t column) {
  const std::string& unit = table.columns[column].unit;
  if (unit == "m") return 1;
  if (unit == "mm") return 1e-3;
  if (unit == "um" || unit == "µm" || unit == "micrometres" || unit == "micrometers") return 1e-6;
  const std::string& name = table.columns[column].name;
  const std::string where = shortened(name, 60);
  if (unit.empty())
    throw InputError(message(
        "{}: the readings in column {} ({}) have no unit; write it into the header, \"{} [mm]\", \"[um]\" or \"[m]\".",
        table.file, column + 1, where, where));
  throw InputError(
      message("{}: the readings in column {} ({}) are in {}, which is none of mm, um and m; write it into the "
              "header, \"{} [mm]\", \"[um]\" or \"[m]\".",
              table.file, column + 1, where, in_quotes(shortened(unit, 40)), where));
}

/// The joints' columns and no other.
Table joints_of(const Table& table, const Robot& robot) {
  Table joints;
  joints.file = table.file;
  joints.has_header = true;
  joints.lines = table.lines;
  joints.rows.resize(table.rows.size());
  for (std::size_t c = 0; c < table.width(); ++c) {
    Table one;
    one.columns = {table.columns[c]};
    if (joint_columns(one, robot) == 0) continue;
    joints.columns.push_back(table.columns[c]);
    for (std::size_t r = 0; r < table.rows.size(); ++r) joints.rows[r].push_back(table.rows[r][c]);
  }
  if (joints.columns.empty())
    throw InputError(message("{}: no column has the name of a joint of the robot, which has: {}.", table.file,
                             shortened(fmt::format("{}", fmt::join(joint_names(robot), " ")), 300)));
  return joints;
}

int whole_number(const Table& table, std::size_t row, std::size_t column) {
  const double number = table.rows[row][column];
  if (!(number >= 0 && number < 64) || number != std::floor(number))
    refuse(table.file, table.lines[row],
           message("column {} ({}) holds {:g}, expected the tip's number, 0 to 63.", column + 1,
                   shortened(table.columns[column].name, 60), number));
  return static_cast<int>(number);
}

}  // namespace

std::optional<Table> parse_touch_table(const std::string& text, const std::string& file, const Robot* robot,
                                       const std::vector<std::string>& columns) {
  const std::vector<std::string> names = robot ? joint_names(*robot) : std::vector<std::string>();
  if (columns.empty()) return parse_table(text, file, names);
  const std::string_view line = std::string_view(text).substr(0, text.find('\n'));
  const char separator = separator_of(line);
  std::string header;
  for (std::size_t c = 0; c < columns.size(); ++c)
    header +=
        (c > 0 ? std::string(1, separator) : "") + (columns[c] == "-" ? fmt::format("left_out_{}", c + 1) : columns[c]);
  auto table = parse_table(header + "\n" + text, file, names);
  for (std::size_t i = 0; table && i < table->lines.size(); ++i) --table->lines[i];  // as they stand in the file
  return table;
}

bool names_fixtures(const Table& table) { return table.has_header && find_column(table, fixture_names).has_value(); }

TouchTable read_touch_table(Table table, const Robot& robot, const std::string& fixture, bool degrees,
                            std::vector<Message>& notes) {
  std::vector<double> times = list_times(table, notes);
  sort_by_time(table, times, notes);
  const JointSeries series = read_joint_table(joints_of(table, robot), robot, degrees, notes);
  const auto touched = find_column(table, fixture_names), value = find_column(table, value_names),
             marker = find_column(table, marker_names), pose = find_column(table, pose_names);
  const double unit = value ? find_unit(table, *value) : 1;
  TouchTable result{series.names, {}};
  int repeated = 0;
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    TouchRow row;
    row.fixture = touched ? table.columns[*touched].words[r] : fixture;
    if (row.fixture.empty())
      refuse(table.file, table.lines[r], "says of no fixture what is touched, expected its name.");
    row.position = series.positions[r];
    if (value && std::isfinite(table.rows[r][*value])) row.value = unit * table.rows[r][*value];
    if (!times.empty()) row.time = times[r];
    if (marker) row.marker = whole_number(table, r, *marker);
    const bool is_same = pose && r > 0 && table.rows[r][*pose] == table.rows[r - 1][*pose] && !result.rows.empty() &&
                         result.rows.back().fixture == row.fixture && result.rows.back().position == row.position;
    if (is_same) {
      ++repeated;
      continue;
    }
    result.rows.push_back(std::move(row));
  }
  if (repeated > 0)
    notes.push_back(
        message("{}: {} lines are of a touch that the line before is of too; each counts once.", table.file, repeated));
  return result;
}

}  // namespace handsight
