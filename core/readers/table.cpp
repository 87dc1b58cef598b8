// SPDX-License-Identifier: Apache-2.0
#include "readers/table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/bounds.h"
#include "base/error.h"
#include "base/letters.h"
#include "base/numbers.h"
#include "base/text.h"
#include "readers/texts/cells.h"

namespace handsight {
namespace {

/// "shoulder [deg]", "q1_deg" and "dial mm" to name and unit.
TableColumn column_of(const std::string& cell) {
  TableColumn column{cell, ""};
  const std::size_t open = cell.find_last_of("[(");
  const bool is_number = open != std::string::npos && open + 2 < cell.size() &&
                         cell.find_first_not_of("0123456789", open + 1) == cell.size() - 1;  // "position[0]"
  if (open != std::string::npos && open > 0 && !is_number && (cell.back() == ']' || cell.back() == ')')) {
    column.unit = plain_unit(lower_case(trimmed(cell.substr(open + 1, cell.size() - open - 2))));
    column.name = trimmed(cell.substr(0, open));
    return column;
  }
  for (const char between : {'_', ' '})
    for (const char* unit : {"deg", "degrees", "rad", "mm", "m", "ms", "us", "ns", "um", "inch"}) {
      const std::string end = between + std::string(unit);
      if (cell.size() > end.size() && lower_case(cell.substr(cell.size() - end.size())) == end) {
        column.unit = plain_unit(unit);
        column.name = cell.substr(0, cell.size() - end.size());
      }
    }
  return column;
}

constexpr double empty_cell = std::numeric_limits<double>::quiet_NaN();

bool names_images(const std::string& column) {
  const std::string small = lower_case(column);
  for (const char* name : {"image", "images", "file", "files", "filename", "file_name", "image_name", "image_file",
                           "imagename", "img", "picture", "photo", "name", "path", "image_path"})
    if (small == name) return true;
  return false;
}

/// Are the cells of the column words though none is the name of an image?
bool names_things(const std::string& column) {
  const std::string small = lower_case(column);
  const bool is_recorded = small.starts_with("field.name") || small.ends_with("frame_id");  // of `rostopic echo -p`
  return small == "fixture" || small == "touched" || is_recorded || names_images(column);
}

bool is_header(const TextCells& cells, bool decimal_commas) {
  return std::none_of(cells.begin(), cells.end(), [&](const std::string& c) {
    const auto n = cell_number(c, decimal_commas);
    return (n && std::isfinite(*n)) || is_image_file_name(c);
  });
}

/// Numbers that are names too: all different, each one of `names` (a time beside them).
bool are_names(const TextCells& cells, const std::vector<std::string>& names) {
  TextCells seen;
  for (const std::string& c : cells) {
    const bool is_name = std::find(names.begin(), names.end(), c) != names.end();
    if ((!is_name && lower_case(c) != "time") || std::find(seen.begin(), seen.end(), c) != seen.end()) return false;
    seen.push_back(c);
  }
  return cells.size() >= 2;
}

struct Line {
  std::string_view text;
  int number = 0;
  bool is_after_gap = false;  // behind an empty line
};

/// Lines with something in them; of a comment that begins its line the words may be the header ("# time x y z").
std::vector<Line> lines_of(std::string_view text, std::string_view& last_comment) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  std::vector<Line> lines;
  bool is_after_gap = false;
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ' || line.back() == '\t')) line.remove_suffix(1);
    if (line.starts_with("p[") && line.ends_with("]")) line = line.substr(2, line.size() - 3);  // as UR's scripts
    if (line.starts_with("% ") && lines.empty()) last_comment = line.substr(1);
    if (line.starts_with("% ")) line = {};  // MATLAB's remarks; "%time" is a column of `rostopic echo -p`
    std::size_t hash = line.find('#');
    while (hash != std::string_view::npos && line.substr(hash).starts_with("#N"))  // "#N/A", "#NUM!"
      hash = line.find('#', hash + 1);
    if (hash == 0 && lines.empty()) last_comment = line.substr(1);
    if (hash != std::string_view::npos) line = line.substr(0, hash);
    const bool is_empty = split_words(line).empty();
    if (!is_empty) lines.push_back({line, number, is_after_gap});
    is_after_gap = is_empty;
  }
  return lines;
}

/// What stands between the cells. Where tabs and blanks are mixed both do, if that makes all lines alike.
char separator_of(const std::vector<Line>& lines) {
  const char separator = cell_separator(lines.back().text);
  if (separator != '\t' && separator != ' ') return separator;
  const auto are_alike = [&](char between) {
    const std::size_t width = split_cells(lines.front().text, between).size();
    return std::all_of(lines.begin(), lines.end(),
                       [&](const Line& line) { return split_cells(line.text, between).size() == width; });
  };
  return separator == '\t' && !are_alike('\t') && are_alike(' ') ? ' ' : separator;
}

/// Programs write results and remarks below a table, behind an empty line: from there on nothing is as wide as it.
std::size_t end_of_rows(const std::vector<Line>& lines, char separator) {
  constexpr std::size_t fewest = 3;
  const auto cells = [&](std::size_t i) { return split_cells(lines[i].text, separator); };
  const std::size_t width = cells(0).size();
  std::size_t end = lines.size();
  while (end > fewest && cells(end - 1).size() != width) --end;
  if (end == lines.size() || !lines[end].is_after_gap) return lines.size();
  const TextCells first = cells(end);
  const bool has_words =
      std::any_of(first.begin(), first.end(), [](const std::string& cell) { return !cell_number(cell, false); });
  return has_words ? end : lines.size();
}

/// Names and units of the columns, from the first line or from a remark before it. Is the first line the header?
bool name_columns(const TextCells& first, std::string_view comment, bool decimal_commas,
                  const std::vector<std::string>& names, Table& table) {
  const bool is_line = is_header(first, decimal_commas) || are_names(first, names);
  TextCells named = is_line ? first : split_cells(comment, cell_separator(comment));
  table.has_header = is_line || (named.size() == first.size() && is_header(named, false));
  if (table.has_header)
    for (const std::string& name : named) table.columns.push_back(column_of(name));
  else
    table.columns.resize(first.size());
  return is_line;
}

/// The columns in which no row has a number and some row has a word: remarks, states, names of what was touched.
std::vector<bool> columns_of_words(const std::vector<TextCells>& rows, std::size_t width, bool decimal_commas) {
  std::vector<bool> has_word(width, false), has_number(width, false);
  for (const TextCells& cells : rows)
    for (std::size_t c = 0; c < width; ++c) {
      const auto number = cell_number(cells[c], decimal_commas);
      has_word[c] = has_word[c] || !number;
      has_number[c] = has_number[c] || (number && std::isfinite(*number));
    }
  for (std::size_t c = 0; c < width; ++c) has_word[c] = has_word[c] && !has_number[c];
  return has_word;
}

/// One row of a table into it.
void add_row(const TextCells& cells, int line, bool decimal_commas, const std::vector<bool>& are_words, Table& table) {
  std::vector<double>& row = table.rows.emplace_back();
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const auto number = cell_number(cells[c], decimal_commas);
    TableColumn& column = table.columns[c];
    if (names_things(column.name) || is_image_file_name(cells[c]) || are_words[c]) {
      column.words.resize(table.rows.size());
      column.words.back() = cells[c];
      row.push_back(number.value_or(empty_cell));
      continue;
    }
    if (!number)
      refuse(table.file, line,
             message("{} stands in column {}{}, expected a finite number such as 0.5.", in_quotes(cells[c]), c + 1,
                     column.name.empty() ? std::string() : " (" + shortened(column.name) + ")"));
    if (std::isfinite(*number) && !bounds::any.hold(*number))
      refuse(table.file, line,
             message("{} stands in column {}, expected a number of at most {:g}.", in_quotes(cells[c]), c + 1,
                     bounds::any.highest));
    row.push_back(*number);
  }
  table.lines.push_back(line);
}

/// Names of points before numbers without a header ("P1 1.2 3.4 5.6") are no column of the table.
void drop_words_without_header(Table& table) {
  for (std::size_t c = table.width(); !table.has_header && c-- > 0;) {
    const std::vector<std::string>& words = table.columns[c].words;
    if (words.empty() || std::any_of(words.begin(), words.end(), is_image_file_name)) continue;
    table.row_words = words;
    table.columns.erase(table.columns.begin() + static_cast<std::ptrdiff_t>(c));
    for (auto& row : table.rows) row.erase(row.begin() + static_cast<std::ptrdiff_t>(c));
  }
}

}  // namespace

std::optional<Table> parse_table(std::string_view text, const std::string& file,
                                 const std::vector<std::string>& names) {
  std::string_view comment;
  std::vector<Line> lines = lines_of(text, comment);
  if (lines.empty()) return std::nullopt;
  const Line last = lines.back();
  if (const std::size_t end = end_of_rows(lines, cell_separator(lines.front().text)); end < lines.size())
    lines.resize(end);
  const char separator = separator_of(lines);
  const bool decimal_commas = separator == ';' && lines.back().text.find(',') != std::string_view::npos &&
                              lines.back().text.find('.') == std::string_view::npos;
  Table table;
  table.file = file;
  TextCells first = split_cells(lines.front().text, separator);
  if (first.size() > 1 && first.back().empty()) first.pop_back();  // many programs end each line with a separator
  if (first.size() < 2) return std::nullopt;
  const bool header_is_a_line = name_columns(first, comment, decimal_commas, names, table);
  if (header_is_a_line && lines.size() > 1) {  // a table has numbers below its names; other texts have not
    const TextCells second = split_cells(lines[1].text, separator);
    const bool is_missing = std::all_of(second.begin(), second.end(), [&](const std::string& cell) {
      return cell_number(cell, decimal_commas).has_value();
    });
    if (second.size() < 2 || (is_header(second, decimal_commas) && !is_missing)) return std::nullopt;
  }
  const std::size_t begin = header_is_a_line ? 1 : 0;
  std::vector<TextCells> rows;
  for (std::size_t i = begin; i < lines.size(); ++i) {
    TextCells& cells = rows.emplace_back(split_cells(lines[i].text, separator));
    if (cells.size() == table.width() + 1 && cells.back().empty()) cells.pop_back();
    if (cells.size() != table.width())
      refuse(file, lines[i].number, message("the line has {} columns, expected {}.", cells.size(), table.width()));
  }
  const std::vector<bool> are_words = columns_of_words(rows, table.width(), decimal_commas);
  for (std::size_t r = 0; r < rows.size(); ++r)
    add_row(rows[r], lines[begin + r].number, decimal_commas, are_words, table);
  if (table.rows.empty()) return std::nullopt;
  for (TableColumn& column : table.columns)
    if (!column.words.empty()) column.words.resize(table.rows.size());
  drop_words_without_header(table);
  if (table.width() < 2) return std::nullopt;
  if (decimal_commas) table.notes.push_back(message("{}: commas are read as decimal points.", file));
  if (lines.back().number != last.number)
    table.notes.push_back(message("{}: what stands below its rows, behind an empty line, is left out (up to line {}).",
                                  file, last.number));
  return table;
}

bool tells_images(const TableColumn& column) {
  return names_images(column.name) || std::any_of(column.words.begin(), column.words.end(), is_image_file_name);
}

std::optional<double> unit_of_lengths(const Table& table, std::size_t column) {
  return metres_of_unit(table.columns[column].unit);
}

std::optional<std::size_t> find_column(const Table& table, const std::string& name) {
  std::optional<std::size_t> found;
  for (std::size_t c = 0; c < table.width(); ++c) {
    if (lower_case(table.columns[c].name) != lower_case(name)) continue;
    if (found) refuse(table.file, 1, message("the header names {} twice, expected each column once.", in_quotes(name)));
    found = c;
  }
  return found;
}

std::optional<std::size_t> find_column(const Table& table, std::initializer_list<const char*> names) {
  for (const char* name : names)
    if (const auto found = find_column(table, name)) return found;
  return std::nullopt;
}

std::vector<double> list_times(const Table& table, std::vector<Message>& notes) {
  const auto column = find_column(table, {"time", "timestamp", "t", "stamp", "seconds", "sec", "time_s", "header.stamp",
                                          "__time", "datetime", "date_time", "date", "zeit", "uhrzeit", "zeitstempel"});
  if (!column) return {};
  require_full(table, {*column});
  std::vector<double> times;
  for (const auto& row : table.rows) times.push_back(row[*column]);
  double unit = 1;
  const std::string& named = table.columns[*column].unit;
  const double largest = *std::max_element(times.begin(), times.end());
  if (named == "ms") unit = 1e-3;
  if (named == "us") unit = 1e-6;
  if (named == "ns") unit = 1e-9;
  if (named.empty() && largest > 1e17)
    unit = 1e-9;  // the time of day since 1970 in ns, us or ms
  else if (named.empty() && largest > 1e14)
    unit = 1e-6;
  else if (named.empty() && largest > 1e11)
    unit = 1e-3;
  if (named.empty() && unit != 1)
    notes.push_back(message("{}: the times are taken for {}.", table.file,
                            unit == 1e-9   ? "nanoseconds"
                            : unit == 1e-6 ? "microseconds"
                                           : "milliseconds"));
  for (double& t : times) t *= unit;
  return times;
}

void sort_by_time(Table& table, std::vector<double>& times, std::vector<Message>& notes) {
  if (times.empty() || std::is_sorted(times.begin(), times.end())) return;
  std::vector<std::size_t> order(times.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return times[a] < times[b]; });
  Table sorted = table;
  std::vector<double> sorted_times;
  for (std::size_t i = 0; i < order.size(); ++i) {
    sorted.rows[i] = table.rows[order[i]];
    sorted.lines[i] = table.lines[order[i]];
    sorted_times.push_back(times[order[i]]);
  }
  for (TableColumn& column : sorted.columns) {
    if (column.words.empty()) continue;
    std::vector<std::string> words;
    for (const std::size_t place : order) words.push_back(column.words[place]);
    column.words = std::move(words);
  }
  table = std::move(sorted);
  times = std::move(sorted_times);
  notes.push_back(message("{}: the lines do not stand in order of time; they were sorted.", table.file));
}

void require_full(const Table& table, const std::vector<std::size_t>& columns) {
  for (std::size_t r = 0; r < table.rows.size(); ++r)
    for (const std::size_t c : columns)
      if (!std::isfinite(table.rows[r][c]))
        refuse(table.file, table.lines[r],
               message("column {} ({}) is empty, expected a number.", c + 1, shortened(table.columns[c].name)));
}

}  // namespace handsight
