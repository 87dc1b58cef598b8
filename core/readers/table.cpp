// SPDX-License-Identifier: Apache-2.0
#include "readers/table.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/bounds.h"
#include "base/error.h"
#include "base/numbers.h"
#include "base/text.h"

namespace handsight {
namespace {

using TableCells = std::vector<std::string>;

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::string plain_cell(std::string_view text) {
  const auto is_space = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  if (text.size() >= 2 && (text.front() == '"' || text.front() == '\'') && text.back() == text.front())
    text = text.substr(1, text.size() - 2);
  return std::string(text);
}

TableCells split(std::string_view line, char separator) {
  TableCells cells;
  if (separator == ' ') {
    for (const std::string_view word : split_words(line)) cells.push_back(plain_cell(word));
    return cells;
  }
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(separator, begin), line.size());
    cells.push_back(plain_cell(line.substr(begin, end - begin)));
    begin = end + 1;
  }
  return cells;
}

char separator_of(std::string_view line) {
  for (const char c : {';', '\t', ','})
    if (line.find(c) != std::string_view::npos) return c;
  return ' ';
}

/// "deg" for all that people write for degrees, and so on.
std::string plain_unit(const std::string& unit) {
  if (unit == "degrees" || unit == "degree" || unit == "°") return "deg";
  if (unit == "radians" || unit == "radian") return "rad";
  if (unit == "millimetres" || unit == "millimeters" || unit == "millimeter") return "mm";
  if (unit == "metres" || unit == "meters" || unit == "meter") return "m";
  return unit;
}

/// "shoulder [deg]" and "q1_deg" to name and unit.
TableColumn column_of(const std::string& cell) {
  TableColumn column{cell, ""};
  const std::size_t open = cell.find_last_of("[(");
  if (open != std::string::npos && open > 0 && (cell.back() == ']' || cell.back() == ')')) {
    column.unit = plain_unit(lower(plain_cell(std::string_view(cell).substr(open + 1, cell.size() - open - 2))));
    column.name = plain_cell(std::string_view(cell).substr(0, open));
    return column;
  }
  for (const char* unit : {"deg", "degrees", "rad", "mm", "m", "ms", "us", "ns"}) {
    const std::string end = std::string("_") + unit;
    if (cell.size() > end.size() && lower(cell.substr(cell.size() - end.size())) == end) {
      column.unit = plain_unit(unit);
      column.name = cell.substr(0, cell.size() - end.size());
    }
  }
  return column;
}

constexpr std::array image_endings{".png", ".jpg", ".jpeg", ".pgm", ".ppm", ".bmp", ".tif", ".tiff", ".webp"};
constexpr double empty_cell = std::numeric_limits<double>::quiet_NaN();

std::optional<double> number_of(const std::string& cell, bool decimal_commas) {
  const std::string small = lower(cell);
  if (cell.empty() || small == "nan" || small == "null" || small == "none" || small == "n/a") return empty_cell;
  if (!decimal_commas) return parse_number(cell);
  std::string text = cell;
  if (const auto comma = text.find(','); comma != std::string::npos) text[comma] = '.';
  return parse_number(text);
}

/// What a cell of a row is: a number, a word where the column is one of names, or nothing that could stand there.
bool is_image_name(const std::string& cell) {
  const std::string small = lower(cell);
  return std::any_of(image_endings.begin(), image_endings.end(),
                     [&](const char* ending) { return small.ends_with(ending); });
}

bool names_images(const std::string& column) {
  const std::string small = lower(column);
  for (const char* name : {"image", "images", "file", "files", "filename", "file_name", "image_name", "image_file",
                           "imagename", "img", "picture", "photo", "name", "path", "image_path"})
    if (small == name) return true;
  return false;
}

/// Are the cells of the column words though none is the name of an image?
bool names_things(const std::string& column) {
  const std::string small = lower(column);
  const bool is_recorded = small.starts_with("field.name") || small.ends_with("frame_id");  // of `rostopic echo -p`
  return small == "fixture" || small == "touched" || is_recorded || names_images(column);
}

bool is_header(const TableCells& cells, bool decimal_commas) {
  return std::none_of(cells.begin(), cells.end(), [&](const std::string& c) {
    const auto n = number_of(c, decimal_commas);
    return (n && std::isfinite(*n)) || is_image_name(c);
  });
}

/// Numbers that are names too: all different, each one of `names` (a time beside them).
bool are_names(const TableCells& cells, const std::vector<std::string>& names) {
  TableCells seen;
  for (const std::string& c : cells) {
    const bool is_name = std::find(names.begin(), names.end(), c) != names.end();
    if ((!is_name && lower(c) != "time") || std::find(seen.begin(), seen.end(), c) != seen.end()) return false;
    seen.push_back(c);
  }
  return cells.size() >= 2;
}

struct Line {
  std::string_view text;
  int number = 0;
};

/// Lines with something in them; of a comment that begins its line the words may be the header ("# time x y z").
std::vector<Line> lines_of(std::string_view text, std::string_view& last_comment) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  std::vector<Line> lines;
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ' || line.back() == '\t')) line.remove_suffix(1);
    if (line.starts_with("p[") && line.ends_with("]")) line = line.substr(2, line.size() - 3);  // as UR's scripts
    const std::size_t hash = line.find('#');
    if (hash == 0 && lines.empty()) last_comment = line.substr(1);
    if (hash != std::string_view::npos) line = line.substr(0, hash);
    if (!split_words(line).empty()) lines.push_back({line, number});
  }
  return lines;
}

}  // namespace

std::optional<Table> parse_table(std::string_view text, const std::string& file,
                                 const std::vector<std::string>& names) {
  std::string_view comment;
  const std::vector<Line> lines = lines_of(text, comment);
  if (lines.empty()) return std::nullopt;
  const char separator = separator_of(lines.back().text);
  const bool decimal_commas = separator == ';' && lines.back().text.find(',') != std::string_view::npos &&
                              lines.back().text.find('.') == std::string_view::npos;
  Table table;
  table.file = file;
  TableCells first = split(lines.front().text, separator);
  if (first.size() > 1 && first.back().empty()) first.pop_back();  // many programs end each line with a separator
  if (first.size() < 2) return std::nullopt;
  const bool header_is_a_line = is_header(first, decimal_commas) || are_names(first, names);
  table.has_header = header_is_a_line;
  if (!table.has_header) {
    const TableCells named = split(comment, separator_of(comment));
    if (named.size() == first.size() && is_header(named, false)) {
      for (const std::string& name : named) table.columns.push_back(column_of(name));
      table.has_header = true;
    } else {
      table.columns.resize(first.size());
    }
  } else {
    for (const std::string& name : first) table.columns.push_back(column_of(name));
  }
  if (header_is_a_line && lines.size() > 1) {  // a table has numbers below its names; other texts have not
    const TableCells second = split(lines[1].text, separator);
    if (second.size() < 2 || is_header(second, decimal_commas)) return std::nullopt;
  }
  for (std::size_t i = header_is_a_line ? 1 : 0; i < lines.size(); ++i) {
    TableCells cells = split(lines[i].text, separator);
    if (cells.size() == table.width() + 1 && cells.back().empty()) cells.pop_back();
    if (cells.size() != table.width())
      refuse(file, lines[i].number, message("the line has {} columns, expected {}.", cells.size(), table.width()));
    std::vector<double>& row = table.rows.emplace_back();
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const auto number = number_of(cells[c], decimal_commas);
      TableColumn& column = table.columns[c];
      if (names_things(column.name) || is_image_name(cells[c])) {
        column.words.resize(table.rows.size());
        column.words.back() = cells[c];
        row.push_back(number.value_or(empty_cell));
        continue;
      }
      if (!number)
        refuse(file, lines[i].number,
               message("{} stands in column {}{}, expected a finite number such as 0.5.", in_quotes(cells[c]), c + 1,
                       table.columns[c].name.empty() ? std::string() : " (" + shortened(table.columns[c].name) + ")"));
      if (std::isfinite(*number) && !bounds::any.hold(*number))
        refuse(file, lines[i].number,
               message("{} stands in column {}, expected a number of at most {:g}.", in_quotes(cells[c]), c + 1,
                       bounds::any.highest));
      row.push_back(*number);
    }
    table.lines.push_back(lines[i].number);
  }
  if (table.rows.empty()) return std::nullopt;
  for (TableColumn& column : table.columns)
    if (!column.words.empty()) column.words.resize(table.rows.size());
  if (decimal_commas) table.notes.push_back(message("{}: commas are read as decimal points.", file));
  return table;
}

std::optional<std::size_t> find_column(const Table& table, const std::string& name) {
  std::optional<std::size_t> found;
  for (std::size_t c = 0; c < table.width(); ++c) {
    if (lower(table.columns[c].name) != lower(name)) continue;
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
  const auto column =
      find_column(table, {"time", "timestamp", "t", "stamp", "seconds", "sec", "time_s", "header.stamp"});
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
