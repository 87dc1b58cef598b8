// SPDX-License-Identifier: Apache-2.0
// Vicon's ASCII export: sections, each of a name, a rate in Hz, the things' names, axes ("Frame,Sub Frame,RX,..."),
// units and a line a frame, until an empty line.
#include <algorithm>
#include <map>

#include "base/error.h"
#include "base/numbers.h"
#include "base/text.h"
#include "readers/mocap/mocap_cells.h"
#include "readers/mocap/mocap_csv.h"

namespace handsight {
namespace {

using namespace mocap;

constexpr const char* section_names[] = {"Objects", "Segments", "Trajectories", "Model Outputs", "Devices", "Joints"};

struct ViconSection {
  std::string name;
  double rate = 0;                             // Hz
  std::size_t names = 0, first = 0, last = 0;  // lines: of the names, of the first frame, behind the last one
};

bool is_thing(const std::string& cell) {
  return std::find(std::begin(section_names), std::end(section_names), cell) != std::end(section_names);
}

std::vector<ViconSection> vicon_sections(const std::vector<Cells>& lines, const std::string& file) {
  std::vector<ViconSection> all;
  for (std::size_t l = 0; l + 5 < lines.size(); ++l) {
    if (!is_thing(lines[l].front())) continue;
    const auto rate = parse_number(lines[l + 1].front());
    if (!rate || !(*rate > 0) || lines[l + 3].front() != "Frame")
      refuse(file, static_cast<int>(l) + 2,
             "is no head of a section of Vicon's, expected its rate, names and axes below.");
    ViconSection s{lines[l].front(), *rate, l + 2, l + 5, l + 5};
    while (s.last < lines.size() && parse_number(lines[s.last].front())) ++s.last;
    all.push_back(s);
    l = s.last - 1;
  }
  return all;
}

/// "Global Angle right:hand" and "right:hand" are of the thing "hand".
std::string thing_of(const std::string& cell) { return cell.substr(cell.rfind(':') + 1); }

std::string column_name(const std::string& axis) {
  static const std::map<std::string, std::string> turns = {{"RX", "rx"}, {"RY", "ry"}, {"RZ", "rz"}, {"RW", "rw"},
                                                           {"TX", "x"},  {"TY", "y"},  {"TZ", "z"},  {"X", "x"},
                                                           {"Y", "y"},   {"Z", "z"}};
  const auto found = turns.find(axis);
  return found == turns.end() ? "" : found->second;
}

/// Things in the order of the file, each with its columns.
std::vector<std::pair<std::string, std::vector<Column>>> things_of(const std::vector<Cells>& lines,
                                                                   const ViconSection& s) {
  std::vector<std::pair<std::string, std::vector<Column>>> all;
  const Cells &names = lines[s.names], &axes = lines[s.names + 1], &units = lines[s.names + 2];
  std::string name;
  for (std::size_t c = 2; c < axes.size(); ++c) {
    if (c < names.size() && !names[c].empty()) name = thing_of(names[c]);
    const std::string column = column_name(axes[c]);
    if (column.empty() || name.empty()) continue;
    if (all.empty() || all.back().first != name) all.push_back({name, {}});
    all.back().second.push_back({c, column, c < units.size() ? units[c] : ""});
  }
  return all;
}

/// Four numbers are a quaternion.
std::vector<Column> with_quaternion(std::vector<Column> columns) {
  if (std::none_of(columns.begin(), columns.end(), [](const Column& c) { return c.name == "rw"; })) return columns;
  for (Column& c : columns)
    if (c.name[0] == 'r') c = {c.at, "q" + c.name.substr(1), ""};
  return columns;
}

}  // namespace

bool is_vicon_csv(const std::string& text) {
  const std::vector<Cells> lines = split_cells(std::string_view(text).substr(0, 4000));
  return lines.size() > 3 && is_thing(lines[0].front()) && parse_number(lines[1].front()) &&
         lines[3].front() == "Frame";
}

MocapTables read_vicon_csv(const std::string& text, const std::string& file) {
  const std::vector<Cells> lines = split_cells(text);
  MocapTables all;
  for (const ViconSection& s : vicon_sections(lines, file)) {
    const double frame = 1 / s.rate;
    if (s.name == "Objects" || s.name == "Segments") {
      for (const auto& [name, columns] : things_of(lines, s))
        all.bodies.push_back(
            {name, read_table_lines(lines, s.first, s.last, 0, frame, with_quaternion(columns), file)});
    } else if (s.name == "Trajectories") {
      std::vector<Column> columns;
      for (const auto& [name, own] : things_of(lines, s))
        for (const Column& c : own) columns.push_back({c.at, name + "_" + c.name, c.unit});
      all.markers = read_table_lines(lines, s.first, s.last, 0, frame, columns, file);
    } else {
      all.notes.push_back(message("{}: the section {} is left out.", file, in_quotes(s.name)));
    }
  }
  if (!all.bodies.empty() && !all.markers.columns.empty()) {
    all.notes.push_back(message("{}: its markers are left out, its rigid bodies count.", file));
    all.markers = {};
  }
  if (all.bodies.empty() && all.markers.columns.empty())
    throw InputError(
        message("{}: has neither Objects nor Segments nor Trajectories; export it again with one of them.", file));
  return all;
}

}  // namespace handsight
