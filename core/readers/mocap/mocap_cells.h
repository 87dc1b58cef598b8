// SPDX-License-Identifier: Apache-2.0
// Lines of a table of motion capture. Internal to the readers of Motive's, Vicon's and Qualisys's.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "readers/table.h"

namespace handsight::mocap {

using Cells = std::vector<std::string>;

/// The lines' cells between commas (tabs), without spaces and quotes around them; empty lines have one empty cell.
std::vector<Cells> split_cells(std::string_view text, char separator = ',');

/// A column of a file and what it becomes of the table of one body or of the markers.
struct Column {
  std::size_t at = 0;
  std::string name, unit;
};

/// A table of time (s; `time_at`, times `seconds`) and these columns, of the lines from `first` to before `last`; cells
/// that are missing or no numbers are NaN. InputError where a time is no number.
Table read_table_lines(const std::vector<Cells>& lines, std::size_t first, std::size_t last, std::size_t time_at,
                       double seconds, const std::vector<Column>& columns, const std::string& file);

}  // namespace handsight::mocap
