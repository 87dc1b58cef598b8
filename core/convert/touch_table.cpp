// SPDX-License-Identifier: Apache-2.0
#include "convert/touch_table.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/text.h"
#include "convert/listed_rows.h"
#include "readers/pose_files.h"
#include "readers/pose_table.h"
#include "readers/texts/cells.h"

namespace handsight {
namespace {

constexpr std::initializer_list<const char*> fixture_names{"fixture", "touched", "surface", "contact", "feature",
                                                           "element", "object",  "ebene",   "fläche",  "objekt"};
constexpr std::initializer_list<const char*> value_names{"value",    "reading", "distance",  "length",   "height",
                                                         "gauge",    "dial",    "indicator", "measured", "measurement",
                                                         "messwert", "abstand", "länge",     "höhe",     "anzeige"};
/// What is off from a length that is the same for all.
constexpr std::initializer_list<const char*> deviation_names{"deviation", "dev", "error", "difference", "abweichung"};
constexpr std::initializer_list<const char*> marker_names{"marker", "tip", "probe"};
constexpr std::initializer_list<const char*> pose_names{"pose", "pose_id", "poseid", "observation"};

/// m of one of the column's unit.
double find_unit(const Table& table, std::size_t column) {
  if (const auto metres = unit_of_lengths(table, column)) return *metres;
  const std::string& unit = table.columns[column].unit;
  const std::string where = shortened(table.columns[column].name, 60);
  if (unit.empty())
    throw InputError(message(
        "{}: the readings in column {} ({}) have no unit; write it into the header, \"{} [mm]\", \"[um]\" or \"[m]\".",
        table.file, column + 1, where, where));
  throw InputError(
      message("{}: the readings in column {} ({}) are in {}, which is none of mm, um and m; write it into the "
              "header, \"{} [mm]\", \"[um]\" or \"[m]\".",
              table.file, column + 1, where, in_quotes(shortened(unit, 40)), where));
}

/// Touches need what every joint stood at.
[[noreturn]] void refuse_without_joints(const Table& table, const Robot& robot) {
  const std::string joints = shortened(fmt::format("{}", fmt::join(joint_names(robot), " ")), 300);
  if (is_pose_table(table, true))
    throw InputError(
        message("{}: tells where the controller believes the hand to be, and not how its joints stood; a touch needs a "
                "column for each joint: {}.",
                table.file, joints));
  throw InputError(message("{}: no column has the name of a joint of the robot, which has: {}.", table.file, joints));
}

/// The column that says what was touched: by its name, or the only one of words.
std::optional<std::size_t> fixture_column(const Table& table) {
  if (const auto named = find_column(table, fixture_names); named && !table.columns[*named].words.empty()) return named;
  std::optional<std::size_t> of_words;
  for (std::size_t c = 0; c < table.width(); ++c) {
    if (table.columns[c].words.empty() || tells_images(table.columns[c])) continue;
    if (of_words) return std::nullopt;
    of_words = c;
  }
  return of_words;
}

/// The joints' columns and no other.
Table joints_of(const Table& table, const Robot& robot) {
  Table joints;
  joints.file = table.file;
  joints.has_header = true;
  joints.lines = table.lines;
  joints.rows.resize(table.rows.size());
  for (const std::size_t c : list_joint_columns(table, robot)) {
    joints.columns.push_back(table.columns[c]);
    for (std::size_t r = 0; r < table.rows.size(); ++r) joints.rows[r].push_back(table.rows[r][c]);
  }
  if (joints.columns.empty()) refuse_without_joints(table, robot);
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
  return parse_headed_table(text, file, names, columns);
}

bool names_fixtures(const Table& table) {
  if (!table.has_header) return false;
  const auto named = find_column(table, fixture_names);
  return named && !table.columns[*named].words.empty();
}

std::vector<std::string> list_fixtures(const Table& table) {
  const auto column = table.has_header ? fixture_column(table) : std::nullopt;
  return column ? table.columns[*column].words : std::vector<std::string>();
}

namespace {

/// Rows in which a joint has no number measure nothing.
void drop_rows_without_joints(Table& table, const Robot& robot, std::vector<Message>& notes) {
  const std::vector<std::size_t> joints = list_joint_columns(table, robot);
  std::size_t kept = 0;
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    if (!std::all_of(joints.begin(), joints.end(), [&](std::size_t c) { return std::isfinite(table.rows[r][c]); }))
      continue;
    if (kept < r) {
      table.rows[kept] = std::move(table.rows[r]);
      table.lines[kept] = table.lines[r];
      for (TableColumn& column : table.columns)
        if (!column.words.empty()) column.words[kept] = column.words[r];
    }
    ++kept;
  }
  if (kept == table.rows.size()) return;
  notes.push_back(message("{}: {} of {} rows have no number for some joint; they are left out.", table.file,
                          table.rows.size() - kept, table.rows.size()));
  table.rows.resize(kept);
  table.lines.resize(kept);
  for (TableColumn& column : table.columns)
    if (!column.words.empty()) column.words.resize(kept);
}

/// What nothing is made of is said.
void tell_unused(const Table& table, const Robot& robot, const std::vector<std::optional<std::size_t>>& used,
                 std::vector<Message>& notes) {
  const std::vector<std::size_t> joints = list_joint_columns(table, robot);
  const auto time = find_column(table, {"time", "timestamp", "t", "stamp"});
  std::vector<std::string> names;
  for (std::size_t c = 0; c < table.width(); ++c) {
    const bool is_used = std::find(joints.begin(), joints.end(), c) != joints.end() || time == c ||
                         std::find(used.begin(), used.end(), std::optional(c)) != used.end();
    if (!is_used && !table.columns[c].name.starts_with("left_out_")) names.push_back(table.columns[c].name);
  }
  if (names.empty()) return;
  notes.push_back(message("{}: nothing is made of its columns {}.", table.file,
                          shortened(fmt::format("{}", fmt::join(names, ", ")), 200)));
}

/// A fixture's name in one word: "socket 1" is socket_1.
std::string plain_name(std::string name) {
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

}  // namespace

TouchTable read_touch_table(Table table, const Robot& robot, const std::string& fixture, bool degrees,
                            std::vector<Message>& notes) {
  notes.insert(notes.end(), table.notes.begin(), table.notes.end());
  if (list_joint_columns(table, robot).empty()) refuse_without_joints(table, robot);
  drop_rows_without_joints(table, robot, notes);
  std::vector<double> times = list_times(table, notes);
  sort_by_time(table, times, notes);
  const JointSeries series = read_joint_table(joints_of(table, robot), robot, degrees, notes);
  const auto touched = fixture_column(table), marker = find_column(table, marker_names),
             pose = find_column(table, pose_names);
  auto value = find_column(table, value_names);
  const bool is_deviation = !value && (value = find_column(table, deviation_names));
  tell_unused(table, robot, {touched, value, marker, pose}, notes);
  const double unit = value ? find_unit(table, *value) : 1;
  TouchTable result{series.names, {}, is_deviation};
  int repeated = 0;
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    TouchRow row;
    row.fixture = plain_name(touched ? table.columns[*touched].words[r] : fixture);
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
