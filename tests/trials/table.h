// SPDX-License-Identifier: Apache-2.0
// The tables that trials and benchmarks print: aligned for people or, with `--markdown` among a program's arguments,
// as they stand in docs/measurements, to be pasted there.
#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace handsight::trials {

/// Where tables go and in which form. In markdown standard output holds tables only: the rest of what the program says
/// goes to the error output.
struct TableOutput {
  bool is_markdown = false;
  std::FILE* file = stdout;
};

/// Takes `--markdown` out of the arguments, wherever it stands; to be called before they are read.
inline TableOutput take_table_output(int& count, char** words) {
  char** const end = std::remove_if(words + std::min(count, 1), words + count,
                                    [](const char* word) { return std::string_view(word) == "--markdown"; });
  if (end == words + count) return {};
  count = static_cast<int>(end - words);
  *end = nullptr;
  std::fflush(stdout);
  std::FILE* const tables = fdopen(dup(STDOUT_FILENO), "w");
  dup2(STDERR_FILENO, STDOUT_FILENO);
  return {true, tables ? tables : stdout};
}

struct TableColumn {
  std::string heading;    // as in docs/measurements, with the unit where `unit` is empty
  int digits = 0;         // behind the point of numbers
  std::string unit = {};  // behind every number
  std::size_t width = 8;  // for people: at least
};

/// A text, a number or nothing.
struct TableCell {
  TableCell() = default;
  TableCell(std::string words) : text(std::move(words)) {}
  TableCell(const char* words) : text(words) {}
  TableCell(double value) : number(value) {}
  TableCell(std::integral auto value) : number(static_cast<double>(value)), is_whole(true) {}

  std::string text;
  std::optional<double> number;  // not printed where it is no number
  bool is_whole = false;         // without digits, with a comma before thousands from 10,000 on
};

inline std::string cell_text(const TableColumn& column, const TableCell& cell) {
  if (!cell.number) return cell.text;
  if (!std::isfinite(*cell.number)) return "";
  std::string text = fmt::format("{:.{}f}", *cell.number, cell.is_whole ? 0 : column.digits);
  if (cell.is_whole && std::abs(*cell.number) >= 1e4)
    for (std::size_t i = text.size(); i > (text[0] == '-' ? 4u : 3u); i -= 3) text.insert(i - 3, ",");
  return column.unit.empty() ? text : text + " " + column.unit;
}

/// Rows are printed as they come, because a trial takes hours and may be stopped. Two spaces part the columns that
/// people see; a cell that is wider than its column moves the rest of its row.
class Table {
 public:
  Table(std::vector<TableColumn> columns, TableOutput output) : columns_(std::move(columns)), output_(output) {}

  /// In markdown with the line below the headings.
  std::string heading() const {
    std::vector<TableCell> headings;
    for (const TableColumn& c : columns_) headings.emplace_back(c.heading);
    std::string text = row(headings);
    if (!output_.is_markdown) return text;
    text += "|";
    for (std::size_t i = 0; i < columns_.size(); ++i) text += "---|";
    return text + "\n";
  }

  /// The first column begins at the left, the others end at the right. Cells that are not given are empty.
  std::string row(const std::vector<TableCell>& cells) const {
    std::string text = output_.is_markdown ? "|" : "";
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const std::string cell = i < cells.size() ? cell_text(columns_[i], cells[i]) : "";
      const std::size_t width = std::max(columns_[i].width, columns_[i].heading.size());
      if (output_.is_markdown)
        text += cell.empty() ? " |" : " " + cell + " |";
      else
        text += i == 0 ? fmt::format("{:<{}}", cell, width) : fmt::format("  {:>{}}", cell, width);
    }
    while (!text.empty() && text.back() == ' ') text.pop_back();
    return text + "\n";
  }

  void print(const std::vector<TableCell>& cells) {
    if (!std::exchange(has_heading_, true)) fmt::print(output_.file, "\n{}", heading());
    fmt::print(output_.file, "{}", row(cells));
    std::fflush(output_.file);
  }

 private:
  std::vector<TableColumn> columns_;
  TableOutput output_;
  bool has_heading_ = false;
};

/// "12 of 40", and with digits "12 of 40, 30.0 %".
inline std::string share_text(long count, long all, std::optional<int> digits = {}) {
  std::string text = fmt::format("{} of {}", count, all);
  if (digits)
    text += fmt::format(", {:.{}f} %", 100.0 * static_cast<double>(count) / std::max(1.0, static_cast<double>(all)),
                        *digits);
  return text;
}

}  // namespace handsight::trials
