// SPDX-License-Identifier: Apache-2.0
#include "readers/texts/cells.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>

#include "base/letters.h"
#include "base/numbers.h"

namespace handsight {
namespace {

constexpr double empty_cell = std::numeric_limits<double>::quiet_NaN();

std::string_view without_blanks(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n\v\f";
  const std::size_t begin = text.find_first_not_of(blanks);
  return begin == std::string_view::npos ? std::string_view()
                                         : text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

/// Whole numbers with these signs between them, one a place of the pattern ("0-0-0"); takes them from the text.
std::optional<std::array<int, 3>> take_three(std::string_view& text, char between) {
  std::array<int, 3> numbers{};
  std::size_t at = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (i > 0 && (at >= text.size() || text[at++] != between)) return std::nullopt;
    std::size_t digits = 0;
    for (; at < text.size() && digits < 4 && text[at] >= '0' && text[at] <= '9'; ++at, ++digits)
      numbers[i] = 10 * numbers[i] + (text[at] - '0');
    if (digits == 0) return std::nullopt;
  }
  text.remove_prefix(at);
  return numbers;
}

/// "Z", "+02:00", "-0130" behind a time, in s; nothing where something else stands there.
std::optional<double> zone_seconds(std::string_view text) {
  if (text.empty() || text == "Z" || text == "z") return 0;
  if (text.front() == ' ') text.remove_prefix(1);
  if (text == "UTC" || text == "GMT") return 0;
  if (text.size() < 3 || (text[0] != '+' && text[0] != '-')) return std::nullopt;
  std::string digits;
  for (const char c : text.substr(1))
    if (c != ':') digits += c;
  if (digits.size() == 2) digits += "00";
  const auto number = parse_integer(digits);
  if (digits.size() != 4 || !number || *number < 0) return std::nullopt;
  const std::int64_t hours = *number / 100, minutes = *number % 100;
  const double seconds = static_cast<double>(3600 * hours + 60 * minutes);
  return text[0] == '-' ? -seconds : seconds;
}

/// ".25" or ",25" at the text's start; takes it.
double take_fraction(std::string_view& text) {
  if (text.empty() || (text.front() != '.' && text.front() != ',')) return 0;
  text.remove_prefix(1);
  double value = 0, place = 0.1;
  while (!text.empty() && text.front() >= '0' && text.front() <= '9') {
    value += place * (text.front() - '0');
    place /= 10;
    text.remove_prefix(1);
  }
  return value;
}

std::optional<double> day_seconds(const std::array<int, 3>& year_month_day) {
  const auto [year, month, day] = year_month_day;
  const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(day))};
  if (!date.ok()) return std::nullopt;
  return 86400.0 * static_cast<double>(std::chrono::sys_days(date).time_since_epoch().count());
}

}  // namespace

char cell_separator(std::string_view line) {
  std::string outside;
  bool is_quoted = false;
  for (const char c : line) {
    is_quoted = is_quoted != (c == '"');
    if (!is_quoted) outside += c;
  }
  for (const char c : {';', '\t', ','})
    if (outside.find(c) != std::string::npos) return c;
  return ' ';
}

std::vector<std::string_view> cell_views(std::string_view line, char separator) {
  if (separator == ' ') return split_words(line);
  std::vector<std::string_view> cells;
  bool is_quoted = false;
  std::size_t begin = 0;
  for (std::size_t at = 0; at <= line.size(); ++at) {
    const bool is_end = at == line.size();
    if (!is_end && line[at] == '"') is_quoted = !is_quoted;
    if (!is_end && (is_quoted || line[at] != separator)) continue;
    cells.push_back(without_blanks(line.substr(begin, at - begin)));
    begin = at + 1;
  }
  return cells;
}

std::string_view unquoted(std::string_view cell) {
  const bool has_quotes =
      cell.size() >= 2 && (cell.front() == '"' || cell.front() == '\'') && cell.back() == cell.front();
  return has_quotes ? cell.substr(1, cell.size() - 2) : cell;
}

TextCells split_cells(std::string_view line, char separator) {
  TextCells cells;
  for (const std::string_view cell : cell_views(line, separator)) cells.emplace_back(unquoted(cell));
  return cells;
}

std::optional<double> clock_seconds(std::string_view cell) {
  std::string_view rest = cell;
  double day = 0;
  if (auto date = take_three(rest, '-'); date || (rest = cell, date = take_three(rest, '/'))) {
    const auto seconds = day_seconds(*date);
    if (!seconds) return std::nullopt;
    day = *seconds;
  } else if (rest = cell, date = take_three(rest, '.'); date && !rest.empty()) {
    const auto seconds = day_seconds({(*date)[2], (*date)[1], (*date)[0]});
    if (!seconds) return std::nullopt;
    day = *seconds;
  } else {
    rest = cell;
  }
  if (rest.size() < cell.size()) {
    if (rest.empty() || (rest.front() != 'T' && rest.front() != ' ' && rest.front() != '_')) return std::nullopt;
    rest.remove_prefix(1);
  }
  const auto clock = take_three(rest, ':');
  if (!clock || (*clock)[0] > 24 || (*clock)[1] > 59 || (*clock)[2] > 60) return std::nullopt;
  const double fraction = take_fraction(rest);
  const auto zone = zone_seconds(rest);
  if (!zone) return std::nullopt;
  return day + 3600.0 * (*clock)[0] + 60.0 * (*clock)[1] + (*clock)[2] + fraction - *zone;
}

std::optional<double> cell_number(const std::string& cell, bool decimal_commas) {
  constexpr std::array nothing{"nan", "+nan", "-nan", "nan(ind)", "null", "none", "n/a",  "na",       "#n/a",   "#nv",
                               "-",   "--",   "---",  "nil",      "inf",  "+inf", "-inf", "infinity", "missing"};
  const std::string small = lower_case(cell);
  if (cell.empty() || std::any_of(nothing.begin(), nothing.end(), [&](const char* word) { return small == word; }))
    return empty_cell;
  std::string text = cell;
  if (const auto comma = text.find(','); decimal_commas && comma != std::string::npos) text[comma] = '.';
  const auto number = parse_number(text);
  return number ? number : clock_seconds(cell);
}

bool is_image_file_name(const std::string& cell) {
  constexpr std::array endings{".png", ".jpg", ".jpeg", ".pgm", ".ppm", ".bmp", ".tif", ".tiff", ".webp"};
  const std::string small = lower_case(cell);
  return std::any_of(endings.begin(), endings.end(), [&](const char* ending) { return small.ends_with(ending); });
}

std::string plain_unit(const std::string& unit) {
  static const std::map<std::string, std::string> plain{{"degrees", "deg"},
                                                        {"degree", "deg"},
                                                        {"°", "deg"},
                                                        {"º", "deg"},
                                                        {"grad", "deg"},
                                                        {"radians", "rad"},
                                                        {"radian", "rad"},
                                                        {"millimetres", "mm"},
                                                        {"millimeters", "mm"},
                                                        {"millimeter", "mm"},
                                                        {"millimetre", "mm"},
                                                        {"metres", "m"},
                                                        {"meters", "m"},
                                                        {"meter", "m"},
                                                        {"metre", "m"},
                                                        {"centimetres", "cm"},
                                                        {"centimeters", "cm"},
                                                        {"micrometres", "um"},
                                                        {"micrometers", "um"},
                                                        {"µm", "um"},
                                                        {"μm", "um"},
                                                        {"micron", "um"},
                                                        {"microns", "um"},
                                                        {"inch", "in"},
                                                        {"inches", "in"},
                                                        {"\"", "in"},
                                                        {"1/100 mm", "0.01 mm"},
                                                        {"1/100mm", "0.01 mm"},
                                                        {"0.01mm", "0.01 mm"},
                                                        {"1/1000 mm", "um"},
                                                        {"0.001 mm", "um"},
                                                        {"feet", "ft"},
                                                        {"foot", "ft"},
                                                        {"milliradians", "mrad"}};
  const auto found = plain.find(unit);
  return found == plain.end() ? unit : found->second;
}

std::optional<double> metres_of_unit(const std::string& unit) {
  static const std::map<std::string, double> metres{{"m", 1},       {"mm", 1e-3},   {"cm", 1e-2},     {"um", 1e-6},
                                                    {"in", 0.0254}, {"ft", 0.3048}, {"0.01 mm", 1e-5}};
  const auto found = metres.find(unit);
  return found == metres.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace handsight
