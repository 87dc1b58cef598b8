// SPDX-License-Identifier: Apache-2.0
// Points of trackers and motion capture, from tables.
#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.h"
#include "base/letters.h"
#include "base/text.h"
#include "readers/pose_files.h"

namespace handsight {
namespace {

constexpr std::size_t most_markers = 64;

struct Triple {
  std::string name;
  std::size_t column[3];
};

/// The number behind "x1", "x_1", "x[1]"; nothing where that is not what it is.
std::optional<std::pair<std::string, int>> numbered_axis_of(const std::string& name) {
  const std::size_t axis = std::string("xyz").find(name.front()), digit = name.find_first_of("0123456789");
  if (axis == std::string::npos || digit == std::string::npos) return std::nullopt;
  const std::size_t end = name.find_first_not_of("0123456789", digit);
  const std::string before = name.substr(1, digit - 1), after = end == std::string::npos ? "" : name.substr(end);
  if (before.find_first_not_of("_.[( -") != std::string::npos || after.find_first_not_of("])") != std::string::npos)
    return std::nullopt;
  return std::pair(name.substr(digit, end - digit), static_cast<int>(axis));
}

/// The name before "_x", ".x", " x", "x", or the number behind "x1"; nothing where the column is of no axis.
std::optional<std::pair<std::string, int>> axis_of(std::string name) {
  if (name.empty()) return std::nullopt;
  name = lower_case(name);
  if (auto numbered = numbered_axis_of(name)) return numbered;
  const std::size_t axis = std::string("xyz").find(name.back());
  if (axis == std::string::npos) return std::nullopt;
  name.pop_back();
  while (!name.empty() && std::string("_. :-").find(name.back()) != std::string::npos) name.pop_back();
  return std::pair(name, static_cast<int>(axis));
}

std::vector<Triple> triples_of(const Table& t) {
  std::vector<std::string> order;
  std::map<std::string, std::vector<std::optional<std::size_t>>> found;
  for (std::size_t c = 0; c < t.width(); ++c) {
    const auto axis = axis_of(t.columns[c].name);
    if (!axis) continue;
    auto& places = found[axis->first];
    if (places.empty()) {
      places.resize(3);
      order.push_back(axis->first);
    }
    places[static_cast<std::size_t>(axis->second)] = c;
  }
  std::vector<Triple> triples;
  for (const std::string& name : order) {
    const auto& p = found[name];
    if (p[0] && p[1] && p[2]) triples.push_back({name, {*p[0], *p[1], *p[2]}});
  }
  return triples;
}

std::optional<Vector3> point_at(const std::vector<double>& row, const Triple& t, double unit) {
  const Vector3 point(row[t.column[0]], row[t.column[1]], row[t.column[2]]);
  if (!point.allFinite() || point.isZero(0)) return std::nullopt;  // zeros: what devices write that see nothing
  return Vector3(point * unit);
}

/// A line a point: grouped by the column that tells the instant.
PointSeries long_table(const Table& table, const std::vector<double>& times, const Triple& triple, std::size_t marker,
                       double unit) {
  PointSeries series;
  const auto instant = find_column(table, {"observation", "frame", "sample", "pose", "instant"});
  if (!instant && times.empty())
    throw InputError(
        message("{}: has a line for each marker, and no column that says which lines are of one instant; expected "
                "`observation` or `time`.",
                table.file));
  std::map<double, std::size_t> places;
  std::map<double, int> markers;  // numbers in the file to those of the session, ascending
  for (const auto& row : table.rows) markers[row[marker]] = 0;
  int next = 0;
  for (auto& [number, place] : markers) place = next++;
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    const double key = instant ? table.rows[r][*instant] : times[r];
    const auto [place, is_new] = places.emplace(key, series.points.size());
    if (is_new) {
      series.points.emplace_back(markers.size());
      if (!times.empty()) series.times.push_back(times[r]);
    }
    series.points[place->second][static_cast<std::size_t>(markers[table.rows[r][marker]])] =
        point_at(table.rows[r], triple, unit);
  }
  return series;
}

}  // namespace

bool is_point_table(const Table& table) {
  if (table.has_header) return !triples_of(table).empty();
  return table.width() % 3 == 0 || table.width() % 3 == 1;
}

PointSeries read_point_table(Table table, std::vector<Message>& notes) {
  if (!table.has_header) {
    const bool has_time = table.width() % 3 == 1;
    if (has_time) table.columns[0].name = "time";
    for (std::size_t c = has_time ? 1 : 0; c < table.width(); ++c)
      table.columns[c].name = fmt::format("m{}_{}", (c - has_time) / 3, "xyz"[(c - has_time) % 3]);
    notes.push_back(message("{}: has no header; its columns are taken for {}x y z of {} points.", table.file,
                            has_time ? "time and " : "", table.width() / 3));
  }
  const std::vector<Triple> triples = triples_of(table);
  check(!triples.empty(), "{} is no table of points", table.file);
  if (triples.size() > most_markers)
    throw InputError(message("{}: holds {} points an instant; a session has up to {} markers.", table.file,
                             triples.size(), most_markers));
  std::vector<double> times = list_times(table, notes);
  sort_by_time(table, times, notes);
  double largest = 0;
  for (const auto& row : table.rows)
    for (const Triple& t : triples)
      if (const auto p = point_at(row, t, 1)) largest = std::max(largest, p->cwiseAbs().maxCoeff());
  const auto reported = unit_of_lengths(table, triples[0].column[0]);
  const double unit = reported ? *reported : largest > longest_m ? 1e-3 : 1;
  if (!reported && unit != 1)
    notes.push_back(
        message("{}: lengths of {:.0f} are taken for millimetres; a session holds metres.", table.file, largest));
  const auto marker = find_column(table, {"marker", "index", "point", "id", "marker_id"});
  if (marker && triples.size() == 1) return long_table(table, times, triples[0], *marker, unit);
  PointSeries series;
  series.times = std::move(times);
  for (const auto& row : table.rows) {
    auto& points = series.points.emplace_back();
    for (const Triple& t : triples) points.push_back(point_at(row, t, unit));
  }
  return series;
}

}  // namespace handsight
