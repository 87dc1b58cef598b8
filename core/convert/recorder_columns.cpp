// SPDX-License-Identifier: Apache-2.0
#include "convert/recorder_columns.h"

#include <fmt/format.h>

#include <array>
#include <sstream>

#include "convert/program_points.h"
#include "readers/texts/cells.h"

namespace handsight {
namespace {

const std::string field = "field.";

TableColumn* exact_column(Table& table, const std::string& name) {
  for (TableColumn& column : table.columns)
    if (column.name == name) return &column;
  return nullptr;
}

/// The joints' positions by the names that the first line has.
void name_positions(Table& table) {
  for (std::size_t i = 0;; ++i) {
    TableColumn* const position = exact_column(table, field + "position" + std::to_string(i));
    const TableColumn* const name = exact_column(table, field + "name" + std::to_string(i));
    if (!position || !name || name->words.empty()) return;
    position->name = name->words.front();
  }
}

void name_fields(Table& table) {
  if (table.columns.empty() || table.columns.front().name != "%time") return;
  name_positions(table);
  table.columns.front().name = "time";
  for (TableColumn& column : table.columns) {
    if (!column.name.starts_with(field)) continue;
    column.words.clear();  // a frame or a joint, no image
    column.name = column.name.substr(field.size());
  }
}

/// UR's: metres and a rotation vector, in rad.
void name_tcp_pose(Table& table) {
  constexpr std::array names{"x", "y", "z", "rvx", "rvy", "rvz"};
  for (const std::string begin : {"actual_TCP_pose_", "target_TCP_pose_"}) {
    std::array<TableColumn*, names.size()> found{};
    bool is_whole = true;
    for (std::size_t i = 0; i < names.size(); ++i) {
      found[i] = exact_column(table, begin + std::to_string(i));
      is_whole = is_whole && found[i];
    }
    if (!is_whole) continue;
    for (std::size_t i = 0; i < names.size(); ++i) *found[i] = {names[i], i < 3 ? "m" : "rad"};
    return;
  }
}

/// EuRoC's (state_groundtruth_estimate0): "p_RS_R_x", "q_RS_w".
void name_euroc(Table& table) {
  for (TableColumn& column : table.columns) {
    if (column.name.starts_with("p_RS_R_")) column.name = column.name.substr(7);
    if (column.name.starts_with("q_RS_")) column = {"q" + column.name.substr(5), ""};
    if (column.name == "#timestamp") column.name = "time";
  }
}

bool is_whole_number(const std::string& cell) {
  return !cell.empty() && cell.size() < 12 && cell.find_first_not_of("0123456789") == std::string::npos;
}

/// A message of `ros2 topic echo --csv`, which has no header: its stamp, its frame, and what follows.
struct EchoedLine {
  std::string time;
  TextCells words, numbers;
};

/// Joint names (or a frame) behind the frame, then numbers.
std::optional<EchoedLine> echoed_line(std::string_view line) {
  const TextCells cells = split_cells(line, ',');
  if (cells.size() < 10 || !is_whole_number(cells[0]) || cells[0].size() < 5 || !is_whole_number(cells[1])) return {};
  if (cells[1].size() > 9 || (!cells[2].empty() && cell_number(cells[2], false))) return {};
  EchoedLine echoed;
  echoed.time = cells[0] + "." + std::string(9 - cells[1].size(), '0') + cells[1];
  for (std::size_t c = 3; c < cells.size(); ++c) {
    const bool is_number = !cells[c].empty() && cell_number(cells[c], false).has_value();
    if (!is_number && !cells[c].empty() && echoed.numbers.empty()) echoed.words.push_back(cells[c]);
    if (is_number) echoed.numbers.push_back(cells[c]);
  }
  return echoed;
}

/// What the numbers are: the readings of the named joints, or a pose; empty: neither.
TextCells echoed_columns(const EchoedLine& line) {
  if (line.words.size() > 1 && line.numbers.size() >= line.words.size()) return line.words;
  if (line.words.size() <= 1 && line.numbers.size() == 7) return {"x", "y", "z", "qx", "qy", "qz", "qw"};
  return {};
}

/// The same text with a header and without frames, as parse_table reads it; nothing where it is another one.
std::optional<std::string> echoed_table(std::string_view text) {
  std::string table;
  TextCells columns;
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line == "---") continue;
    const auto echoed = echoed_line(line);
    if (!echoed) return std::nullopt;
    if (table.empty()) {
      columns = echoed_columns(*echoed);
      if (columns.empty()) return std::nullopt;
      table = fmt::format("time [s],{}\n", fmt::join(columns, ","));
    }
    if (echoed_columns(*echoed) != columns) return std::nullopt;  // another robot's message
    table += fmt::format(
        "{},{}\n", echoed->time,
        fmt::join(echoed->numbers.begin(), echoed->numbers.begin() + static_cast<std::ptrdiff_t>(columns.size()), ","));
  }
  return table.empty() ? std::nullopt : std::optional(table);
}

}  // namespace

std::optional<Table> parse_recorded_table(std::string_view text, const std::string& file,
                                          const std::vector<std::string>& names) {
  if (auto points = program_points(text, file)) return points;
  if (const auto echoed = echoed_table(text)) return parse_table(*echoed, file, names);
  std::optional<Table> table = parse_table(text, file, names);
  if (!table) return table;
  name_euroc(*table);
  name_fields(*table);
  name_tcp_pose(*table);
  return table;
}

}  // namespace handsight
