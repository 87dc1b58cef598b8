// SPDX-License-Identifier: Apache-2.0
#include "readers/mocap/mocap_cells.h"

#include <algorithm>
#include <limits>

#include "base/error.h"
#include "base/letters.h"
#include "base/numbers.h"
#include "base/text.h"

namespace handsight::mocap {
namespace {

std::string bare(std::string_view cell) { return trimmed(cell, " \t\r\""); }

}  // namespace

std::vector<Cells> split_cells(std::string_view text, char separator) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  std::vector<Cells> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    Cells& cells = lines.emplace_back();
    for (std::size_t comma = 0; comma != std::string_view::npos;) {
      comma = line.find(separator);
      cells.push_back(bare(line.substr(0, comma)));
      if (comma != std::string_view::npos) line.remove_prefix(comma + 1);
    }
  }
  return lines;
}

Table read_table_lines(const std::vector<Cells>& lines, std::size_t first, std::size_t last, std::size_t time_at,
                       double seconds, const std::vector<Column>& columns, const std::string& file) {
  Table table;
  table.file = file;
  table.has_header = true;
  table.columns.push_back({"time", "s"});
  for (const Column& column : columns) table.columns.push_back({column.name, column.unit});
  for (std::size_t l = first; l < last; ++l) {
    const Cells& cells = lines[l];
    const auto time = time_at < cells.size() ? parse_number(cells[time_at]) : std::nullopt;
    if (!time) refuse(file, static_cast<int>(l) + 1, "does not begin with a number, expected that of a frame.");
    std::vector<double>& row = table.rows.emplace_back();
    row.push_back(*time * seconds);
    for (const Column& column : columns)
      row.push_back(column.at < cells.size()
                        ? parse_number(cells[column.at]).value_or(std::numeric_limits<double>::quiet_NaN())
                        : std::numeric_limits<double>::quiet_NaN());
    table.lines.push_back(static_cast<int>(l) + 1);
  }
  if (table.rows.empty())
    throw InputError(message("{}: has no frames below its header; expected a line a frame.", file));
  return table;
}

}  // namespace handsight::mocap
