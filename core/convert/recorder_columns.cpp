// SPDX-License-Identifier: Apache-2.0
#include "convert/recorder_columns.h"

#include <array>

#include "convert/program_points.h"

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

}  // namespace

std::optional<Table> parse_recorded_table(std::string_view text, const std::string& file,
                                          const std::vector<std::string>& names) {
  if (auto points = program_points(text, file)) return points;
  std::optional<Table> table = parse_table(text, file, names);
  if (!table) return table;
  name_fields(*table);
  name_tcp_pose(*table);
  return table;
}

}  // namespace handsight
