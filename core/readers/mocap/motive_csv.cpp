// SPDX-License-Identifier: Apache-2.0
// Motive's export (https://docs.optitrack.com, "Data Export: CSV"): settings in the first line, then lines of the
// columns' kinds, names, IDs, "Rotation" or "Position", and axes, of which the last begins with "Frame".
#include <algorithm>
#include <map>

#include "base/error.h"
#include "base/text.h"
#include "readers/mocap/mocap_cells.h"
#include "readers/mocap/mocap_csv.h"

namespace handsight {
namespace {

using namespace mocap;

struct Header {
  std::size_t axes = 0;  // the line that begins with "Frame"
  Cells kinds, names, quantities;
  std::map<std::string, std::string> settings;
};

bool holds(const Cells& cells, const char* wanted) {
  return std::find(cells.begin(), cells.end(), wanted) != cells.end();
}

Header header_of(const std::vector<Cells>& lines, const std::string& file) {
  Header h;
  while (h.axes < lines.size() && lines[h.axes].front() != "Frame") ++h.axes;
  for (std::size_t i = 0; i + 1 < lines[0].size(); i += 2) h.settings[lines[0][i]] = lines[0][i + 1];
  for (std::size_t l = 1; l < std::min(h.axes, lines.size()); ++l) {
    if (holds(lines[l], "Rigid Body") || holds(lines[l], "Marker")) {
      h.kinds = lines[l];
      if (l + 1 < h.axes) h.names = lines[l + 1];
    }
    if (holds(lines[l], "Position")) h.quantities = lines[l];
  }
  if (h.axes >= lines.size() || h.kinds.empty() || h.names.empty() || h.quantities.empty())
    throw InputError(
        message("{}: begins as Motive's CSV does and has no rigid bodies or markers in its header; export it again "
                "with them.",
                file));
  for (Cells* cells : {&h.kinds, &h.names, &h.quantities}) cells->resize(lines[h.axes].size());
  return h;
}

std::string setting(const Header& h, const char* name) {
  const auto found = h.settings.find(name);
  return found == h.settings.end() ? "" : found->second;
}

std::string find_unit(const Header& h) {
  const std::string unit = setting(h, "Length Units");
  return unit.starts_with("Milli") ? "mm" : unit.starts_with("Centi") ? "cm" : "m";
}

void require_quaternions(const Header& h, const std::string& file) {
  const std::string kind = setting(h, "Rotation Type");
  if (kind.empty() || kind == "Quaternion") return;
  throw InputError(message("{}: its turns are Euler angles ({}); export it again with the rotation type Quaternion.",
                           file, in_quotes(kind)));
}

}  // namespace

bool is_motive_csv(const std::string& text) {
  return std::string_view(text).substr(text.starts_with("\xEF\xBB\xBF") ? 3 : 0).starts_with("Format Version,");
}

MocapTables read_motive_csv(const std::string& text, const std::string& file) {
  const std::vector<Cells> lines = split_cells(text);
  const Header h = header_of(lines, file);
  const Cells& axes = lines[h.axes];
  const std::string unit = find_unit(h);
  std::vector<std::string> order;
  std::map<std::string, std::vector<Column>> bodies;
  std::vector<Column> markers;
  std::size_t left_out = 0;
  for (std::size_t c = 2; c < axes.size(); ++c) {
    const std::string axis = axes[c].size() == 1 ? std::string(1, static_cast<char>(axes[c][0] - 'A' + 'a')) : "";
    const bool is_place = h.quantities[c] == "Position", is_turn = h.quantities[c] == "Rotation";
    if (axis.empty() || (!is_place && !is_turn)) continue;
    if (h.kinds[c] == "Rigid Body") {
      if (!bodies.contains(h.names[c])) order.push_back(h.names[c]);
      bodies[h.names[c]].push_back({c, is_turn ? "q" + axis : axis, is_turn ? "" : unit});
    } else if (h.kinds[c] == "Marker" && is_place && !h.names[c].starts_with("Unlabeled")) {
      markers.push_back({c, h.names[c] + "_" + axis, unit});
    } else {
      left_out += axis == "x";
    }
  }
  MocapTables all;
  std::size_t last = lines.size();
  while (last > h.axes + 1 && lines[last - 1] == Cells{""}) --last;
  if (!bodies.empty()) require_quaternions(h, file);
  for (const std::string& name : order)
    all.bodies.push_back({name, read_table_lines(lines, h.axes + 1, last, 1, 1, bodies[name], file)});
  if (order.empty()) all.markers = read_table_lines(lines, h.axes + 1, last, 1, 1, markers, file);
  left_out += order.empty() ? 0 : markers.size() / 3;
  if (left_out > 0)
    all.notes.push_back(message("{}: {} markers beside the rigid bodies are left out.", file, left_out));
  return all;
}

}  // namespace handsight
