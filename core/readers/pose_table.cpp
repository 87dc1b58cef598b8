// SPDX-License-Identifier: Apache-2.0
#include "readers/pose_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "base/bounds.h"
#include "base/error.h"
#include "base/text.h"
#include "readers/pose_columns.h"

namespace handsight {
namespace {

constexpr double most_radians = 2 * std::numbers::pi + 0.2;  // a little beyond a whole turn: more can only be degrees

bool is_missing(const std::vector<double>& row, const PoseColumns& p) {
  const auto is_empty = [&](std::size_t c) { return !std::isfinite(row[c]); };
  return std::any_of(p.xyz.begin(), p.xyz.end(), is_empty) || std::any_of(p.turn.begin(), p.turn.end(), is_empty);
}

/// Zeros, or no motion at all: what programs write where a detector has found nothing.
bool is_placeholder(const std::vector<double>& row, const PoseColumns& p) {
  const auto is_zero = [&](std::size_t c) { return row[c] == 0; };
  if (!std::all_of(p.xyz.begin(), p.xyz.end(), is_zero)) return false;
  const auto ones = std::count_if(p.turn.begin(), p.turn.end(), [&](std::size_t c) { return row[c] == 1; });
  const auto zeros = std::count_if(p.turn.begin(), p.turn.end(), is_zero);
  const auto others = std::ssize(p.turn) - ones - zeros;
  return others == 0 && ones <= (p.turn.size() == 4 ? 1 : p.turn.size() == 9 ? 3 : 0);
}

/// By what rows are called, without those that are left out.
struct Keys {
  std::vector<double> times, numbers;
  std::vector<std::string> names;
  std::vector<std::size_t> places;
};

/// Whole numbers, each once, or nothing.
std::vector<double> list_numbers(const Table& t) {
  const auto c = find_column(t, {"number", "nr", "no", "index", "idx", "id", "sample", "pose", "frame", "observation",
                                 "image_id", "shot", "i", "n", "seq", "#"});
  if (!c || !t.columns[*c].words.empty()) return {};
  std::vector<double> numbers;
  std::set<double> once;
  for (const auto& row : t.rows) {
    if (row[*c] != std::floor(row[*c]) || !once.insert(row[*c]).second) return {};
    numbers.push_back(row[*c]);
  }
  return numbers;
}

std::vector<std::string> list_names(const Table& t) {
  for (const TableColumn& column : t.columns)
    if (!column.words.empty() && tells_images(column)) return column.words;
  return {};
}

/// Of each row its place in the file.
std::vector<std::size_t> list_places(const Table& t) {
  std::vector<int> lines = t.lines;
  std::sort(lines.begin(), lines.end());
  std::vector<std::size_t> places;
  for (const int line : t.lines)
    places.push_back(static_cast<std::size_t>(std::lower_bound(lines.begin(), lines.end(), line) - lines.begin()));
  return places;
}

/// The columns of poses have no other meaning: T of O A T is no time.
Table without_names_of(Table t, const std::vector<PoseColumns>& poses) {
  for (const PoseColumns& p : poses) {
    for (const std::size_t c : p.xyz) t.columns[c].name.clear();
    for (const std::size_t c : p.turn) t.columns[c].name.clear();
  }
  return t;
}

Keys keys_of(Table& t, std::vector<Message>& notes) {
  Keys k;
  k.times = list_times(t, notes);
  sort_by_time(t, k.times, notes);
  k.numbers = list_numbers(t);
  k.names = list_names(t);
  k.places = list_places(t);
  return k;
}

template <class T>
void keep(const std::vector<T>& all, std::size_t row, std::vector<T>& kept) {
  if (!all.empty()) kept.push_back(all[row]);
}

double largest_place(const Table& t, const PoseColumns& p) {
  double largest = 0;
  for (const auto& row : t.rows)
    for (const std::size_t c : p.xyz)
      if (std::isfinite(row[c])) largest = std::max(largest, std::abs(row[c]));
  return largest;
}

double unit_of_places(const Table& t, const PoseColumns& p, const std::string& what, std::vector<Message>& notes) {
  if (const auto unit = unit_of_lengths(t, p.xyz[0])) return *unit;
  const double largest = largest_place(t, p);
  if (largest <= longest_m) return 1;
  notes.push_back(message("{}: lengths of {:.0f} are taken for millimetres; a session holds metres.", what, largest));
  return 1e-3;
}

double largest_turn(const Table& t, const PoseColumns& p) {
  double largest = 0;
  for (const auto& row : t.rows)
    for (const std::size_t c : p.turn)
      if (std::isfinite(row[c])) largest = std::max(largest, std::abs(row[c]));
  return largest;
}

/// Without a header the turn may stand before the place.
void add_turns_first(const Table& t, const PoseColumns& p, const std::vector<AngleKind>& kinds, bool degrees,
                     ReadPoses& read) {
  constexpr double most_degrees = 400;
  const double largest = largest_place(t, p);
  if (largest > most_degrees) return;  // mm of a place
  for (TurnReading reading : list_readings(kinds, "", degrees, false, largest)) {
    reading.turn_first = true;
    read.turns.readings.push_back(reading);
  }
}

bool has_unit_quaternions(const ReadPoses& read) {
  return std::all_of(read.turns.numbers.begin(), read.turns.numbers.end(), [](const std::vector<double>& q) {
    return std::abs(std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3])) - 1) < 0.05;
  });
}

/// What the columns, and who brings them, say of the turns.
void say_readings(const Table& t, const PoseColumns& p, const PoseTableOptions& o, const std::string& what,
                  ReadPoses& read, std::vector<Message>& notes) {
  std::vector<AngleKind> kinds = p.kinds;
  bool usually_degrees = p.usually_degrees;
  read.turns.columns = p.text;
  read.turns.first_is_usual = p.first_is_usual;
  if (!o.angles.empty()) {
    const NamedAngleKind reported = named_angle_kind(o.angles);
    if (angle_count(reported.kind) == p.turn.size()) {
      kinds = {reported.kind};
      usually_degrees = reported.usually_degrees;
      read.turns.first_is_usual = true;
      read.turns.is_reported = true;
    }
  }
  const std::string& unit = t.columns[p.turn[0]].unit;
  const double largest = largest_turn(t, p);
  read.turns.readings = list_readings(kinds, unit, o.degrees, usually_degrees, largest);
  if (!t.has_header && p.turn.size() == 3) add_turns_first(t, p, kinds, o.degrees, read);
  if (p.turn.size() == 3 && unit != "deg" && unit != "rad" && !o.degrees && largest > most_radians)
    notes.push_back(message("{}: angles of up to {:.0f} can only be degrees; they are read so.", what, largest));
}

void refuse_impossible(const ReadPoses& read, const std::string& what) {
  for (std::size_t i = 0; i < read.series.poses.size(); ++i)
    for (const double x : read.series.poses[i].translation)
      if (!bounds::length.hold(x))
        throw InputError(message("{}: pose {} lies outside of any room; expected lengths in m or mm.", what, i));
  if (read.turns.numbers.empty())
    throw InputError(message("{}: has no row with a whole pose; expected a place and a rotation in each.", what));
  if (read.turns.numbers[0].size() == 4 && !has_unit_quaternions(read))
    throw InputError(message("{}: a pose has no unit quaternion ({}); expected four numbers whose squares sum to 1.",
                             what, read.turns.columns));
}

ReadPoses read_columns(const Table& t, const PoseColumns& p, const Keys& keys, const PoseTableOptions& o,
                       const std::string& what, std::vector<Message>& notes) {
  ReadPoses read;
  read.role = p.role;
  PoseSeries& s = read.series;
  s.row_count = t.rows.size();
  const double unit = unit_of_places(t, p, what, notes);
  std::size_t placeholders = 0;
  for (std::size_t r = 0; r < t.rows.size(); ++r) {
    const auto& row = t.rows[r];
    if (is_missing(row, p)) continue;
    if (is_placeholder(row, p)) {
      ++placeholders;
      continue;
    }
    s.poses.push_back({Matrix3::Identity(), unit * Vector3(row[p.xyz[0]], row[p.xyz[1]], row[p.xyz[2]])});
    auto& numbers = read.turns.numbers.emplace_back();
    for (const std::size_t c : p.turn) numbers.push_back(row[c]);
    if (!t.has_header && p.turn.size() == 3) read.turns.places.push_back({row[p.xyz[0]], row[p.xyz[1]], row[p.xyz[2]]});
    keep(keys.times, r, s.times);
    keep(keys.numbers, r, s.numbers);
    keep(keys.names, r, s.names);
    keep(keys.places, r, s.places);
  }
  if (const std::size_t missing = t.rows.size() - s.poses.size() - placeholders; missing > 0 && !s.poses.empty())
    notes.push_back(message("{}: {} of {} rows hold no whole pose (nan or empty); there nothing was measured.", what,
                            missing, t.rows.size()));
  if (placeholders > 0)
    notes.push_back(
        message("{}: {} of {} rows hold zeros alone, as programs write where nothing was found; they are "
                "left out.",
                what, placeholders, t.rows.size()));
  say_readings(t, p, o, what, read, notes);
  refuse_impossible(read, what);
  read_turns(read.turns, read.turns.readings.front(), s);
  return read;
}

}  // namespace

std::vector<TurnReading> list_readings(std::vector<AngleKind> kinds, const std::string& unit, bool says_degrees,
                                       bool usually_degrees, double largest) {
  std::vector<TurnReading> all;
  const bool is_of_angles = angle_count(kinds.front()) == 3;
  const bool only_degrees = unit == "deg" || (unit != "rad" && (says_degrees || largest > most_radians));
  for (const bool degrees : {usually_degrees, !usually_degrees}) {
    if (!is_of_angles && degrees) continue;
    if (is_of_angles && (only_degrees ? !degrees : unit == "rad" && degrees)) continue;
    for (const AngleKind kind : kinds) all.push_back({kind, degrees});
  }
  return all;
}

namespace {

/// The unit of places that stand where turns do otherwise: m, or mm where they could be no metres.
double unit_of(const std::vector<std::vector<double>>& places) {
  double largest = 0;
  for (const auto& place : places)
    for (const double x : place) largest = std::max(largest, std::abs(x));
  return largest > longest_m ? 1e-3 : 1;
}

}  // namespace

void read_turns(const Turns& turns, const TurnReading& reading, PoseSeries& series) {
  const double unit = reading.turn_first ? unit_of(turns.numbers) : 1;
  for (std::size_t i = 0; i < series.poses.size(); ++i) {
    std::vector<double> numbers = reading.turn_first ? turns.places[i] : turns.numbers[i];
    if (reading.degrees)
      for (double& n : numbers) n *= std::numbers::pi / 180;
    series.poses[i].rotation = rotation_by(reading.kind, numbers);
    if (reading.turn_first) series.poses[i].translation = unit * Vector3(turns.numbers[i].data());
  }
}

Message columns_text(const Turns& turns, const TurnReading& reading) {
  return reading.turn_first ? Message("the three columns before the last three") : turns.columns;
}

Message reading_text(const TurnReading& reading) {
  if (angle_count(reading.kind) != 3) return angle_kind_text(reading.kind);
  return message("{}{}", angle_kind_text(reading.kind), reading.degrees ? " in degrees" : " in rad");
}

bool is_pose_table(const Table& table, bool has_robot) {
  return !pose_columns(with_matrices_in_rows(table), has_robot).empty();
}

std::vector<ReadPoses> read_pose_table(const Table& given, bool has_robot, const PoseTableOptions& options,
                                       std::vector<Message>& notes) {
  Table table = with_matrices_in_rows(given);
  const std::vector<PoseColumns> poses = pose_columns(table, has_robot);
  check(!poses.empty(), "{} is no table of poses", table.file);
  if (!table.has_header && table.width() % 7 == 1 && table.columns[0].words.empty() && poses[0].turn.size() == 4)
    table.columns[0].name = "time";
  table = without_names_of(std::move(table), poses);
  const Keys keys = keys_of(table, notes);
  std::vector<ReadPoses> all;
  for (const PoseColumns& p : poses) {
    const std::string what = p.role.empty() ? table.file : fmt::format("{} ({})", table.file, shortened(p.role, 30));
    if (!table.has_header && p.turn.size() == 4)
      notes.push_back(message("{}: has no header; its columns are taken for {}x y z qx qy qz qw.", what,
                              table.columns[0].name == "time" ? "time " : ""));
    all.push_back(read_columns(table, p, keys, options, what, notes));
  }
  return all;
}

}  // namespace handsight
