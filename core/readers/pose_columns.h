// SPDX-License-Identifier: Apache-2.0
// Which columns of a table hold a pose. Internal to pose_table.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/message.h"
#include "geometry/angle_kinds.h"
#include "readers/table.h"

namespace handsight {

struct PoseColumns {
  std::string role;                    // what stands before or behind the columns' names; empty: nothing
  std::vector<std::size_t> xyz, turn;  // of a matrix its nine numbers row by row
  std::vector<AngleKind> kinds;        // likeliest first
  bool first_is_usual = false, usually_degrees = false;
  Message text;  // "rx ry rz"
};

/// None, one or two (the flange's first where nothing names them).
std::vector<PoseColumns> pose_columns(const Table& table, bool has_robot);

/// A table of four columns whose rows are 4x4 matrices below each other: with a matrix in each row; as it is otherwise.
Table with_matrices_in_rows(const Table& table);

}  // namespace handsight
