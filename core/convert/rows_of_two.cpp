// SPDX-License-Identifier: Apache-2.0
#include "convert/rows_of_two.h"

#include <algorithm>
#include <array>

#include "base/letters.h"
#include "readers/texts/cells.h"

namespace handsight {
namespace {

constexpr std::size_t fewest_rows = 3;  // of each

constexpr std::array of_the_flange{"hand", "robot", "gripper", "flange", "arm", "tcp", "tool", "end", "effector", "ee"};
constexpr std::array of_the_target{"eye", "camera", "cam",    "target",  "marker",  "board",
                                   "tag", "calib",  "object", "pattern", "tracker", "sensor"};

template <class Words>
bool is_one_of(const std::string& word, const Words& words) {
  return std::any_of(words.begin(), words.end(), [&](const char* one) { return lower_case(word) == one; });
}

/// The two words of a column, the flange's first; empty where there are others, or not as many of each.
std::vector<std::string> two_words(const std::vector<std::string>& column) {
  std::vector<std::string> words;
  for (const std::string& word : column)
    if (std::find(words.begin(), words.end(), word) == words.end()) words.push_back(word);
  if (words.size() != 2) return {};
  if (is_one_of(words[1], of_the_flange)) std::swap(words[0], words[1]);
  if (!is_one_of(words[0], of_the_flange) || !is_one_of(words[1], of_the_target)) return {};
  const auto first = static_cast<std::size_t>(std::count(column.begin(), column.end(), words[0]));
  return 2 * first == column.size() && first >= fewest_rows ? words : std::vector<std::string>();
}

RowsOf rows_with(const Table& table, const std::vector<std::string>& column, const std::string& word) {
  RowsOf of{word, table};
  Table& t = of.table;
  t.rows.clear(), t.lines.clear(), t.row_words.clear(), t.notes.clear();
  for (TableColumn& c : t.columns) c.words.clear();
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    if (column[r] != word) continue;
    t.rows.push_back(table.rows[r]);
    t.lines.push_back(table.lines[r]);
    for (std::size_t c = 0; c < table.width(); ++c)
      if (!table.columns[c].words.empty()) t.columns[c].words.push_back(table.columns[c].words[r]);
  }
  return of;
}

}  // namespace

std::vector<RowsOf> rows_of_two(const Table& table) {
  std::vector<std::vector<std::string>> columns{table.row_words};
  for (const TableColumn& column : table.columns) columns.push_back(column.words);
  for (const auto& column : columns)
    if (const auto words = two_words(column); !words.empty())
      return {rows_with(table, column, words[0]), rows_with(table, column, words[1])};
  return {};
}

}  // namespace handsight
