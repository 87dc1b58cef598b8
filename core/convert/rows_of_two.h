// SPDX-License-Identifier: Apache-2.0
// One table in which a word says of each row whose pose it is. Internal to convert.
#pragma once

#include <string>
#include <vector>

#include "readers/table.h"

namespace handsight {

/// The rows of one thing each, by the word that stands in them.
struct RowsOf {
  std::string word;  // "hand"
  Table table;
};

/// The rows of the flange and those of the target ("hand,0.1,..." and "eye,0.2,..."), by a column of these words (in
/// any place; without a header before the numbers). Empty: no such column, or not as many rows of each.
std::vector<RowsOf> rows_of_two(const Table& table);

}  // namespace handsight
