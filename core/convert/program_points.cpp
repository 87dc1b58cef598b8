// SPDX-License-Identifier: Apache-2.0
#include "convert/program_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

#include "base/numbers.h"
#include "geometry/angle_kinds.h"

namespace handsight {
namespace {

struct Point {
  int line = 0;
  std::array<double, 3> place{};  // mm
  Matrix3 rotation = Matrix3::Identity();
};

bool is_space(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

/// The number that begins here, taken off the text; nothing where none does.
std::optional<double> take_number(std::string_view& text) {
  while (!text.empty() && (is_space(text.front()) || text.front() == '=')) text.remove_prefix(1);
  std::size_t end = 0;
  while (end < text.size() && std::string_view("+-.0123456789eE").find(text[end]) != std::string_view::npos) ++end;
  const auto number = parse_number(text.substr(0, end));
  if (number) text.remove_prefix(end);
  return number;
}

/// The letters and digits that begin here, taken off the text.
std::string_view take_name(std::string_view& text) {
  std::size_t end = 0;
  while (end < text.size() && std::isalnum(static_cast<unsigned char>(text[end]))) ++end;
  const std::string_view name = text.substr(0, end);
  text.remove_prefix(end);
  return name;
}

/// "X 430.1,Y -20.3" and "X = 430.1  mm,": what stands in the braces by name.
std::map<std::string, double> numbers_in(std::string_view braces) {
  std::map<std::string, double> numbers;
  while (!braces.empty()) {
    const std::string name(take_name(braces));
    if (name.empty()) {
      braces.remove_prefix(1);
    } else if (const auto number = take_number(braces)) {
      numbers.emplace(name, *number);
    }
  }
  return numbers;
}

std::optional<Point> named_point(const std::map<std::string, double>& numbers,
                                 const std::array<const char*, 3>& turn_names, AngleKind kind) {
  Point point;
  std::vector<double> turn;
  const std::array names{"X", "Y", "Z"};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto place = numbers.find(names[i]), angle = numbers.find(turn_names[i]);
    if (place == numbers.end() || angle == numbers.end()) return std::nullopt;
    point.place[i] = place->second;
    turn.push_back(angle->second * std::numbers::pi / 180);
  }
  point.rotation = rotation_by(kind, turn);
  return point;
}

int line_at(std::string_view text, std::size_t place) {
  return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(place), '\n'));
}

/// Points in braces: of KUKA with A B C, of Fanuc with W P R.
std::vector<Point> points_in_braces(std::string_view text, const std::array<const char*, 3>& turn, AngleKind kind) {
  std::vector<Point> points;
  for (std::size_t begin = text.find('{'); begin != std::string_view::npos; begin = text.find('{', begin + 1)) {
    const std::size_t end = text.find('}', begin);
    if (end == std::string_view::npos) break;
    auto point = named_point(numbers_in(text.substr(begin + 1, end - begin - 1)), turn, kind);
    if (!point) continue;
    point->line = line_at(text, begin);
    points.push_back(*point);
  }
  return points;
}

/// The first seven numbers of "[[x,y,z],[q1,q2,q3,q4],...": a place and a quaternion with w first.
std::optional<Point> point_in_brackets(std::string_view text) {
  std::vector<double> numbers;
  while (numbers.size() < 7 && !text.empty()) {
    while (!text.empty() &&
           (is_space(text.front()) || text.front() == '[' || text.front() == ']' || text.front() == ','))
      text.remove_prefix(1);
    const auto number = take_number(text);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  const std::vector<double> q(numbers.begin() + 3, numbers.end());
  if (numbers.size() < 7 || std::abs(std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3])) - 1) > 0.05)
    return std::nullopt;
  Point point;
  std::copy_n(numbers.begin(), 3, point.place.begin());
  point.rotation = rotation_by(AngleKind::quaternion_wxyz, q);
  return point;
}

/// "robtarget p10:=[[600,0,700],[0.7,0,0.7,0],...": declared, not used.
std::vector<Point> robtargets(std::string_view text) {
  constexpr std::string_view word = "robtarget ";
  std::vector<Point> points;
  for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
    const std::string_view line = text.substr(at, text.find(';', at) - at);
    const std::size_t value = line.find(":=");
    if (value == std::string_view::npos) continue;
    auto point = point_in_brackets(line.substr(value + 2));
    if (!point) continue;
    point->line = line_at(text, at);
    points.push_back(*point);
  }
  return points;
}

/// Six numbers of a place and a turn by angles in degrees.
std::optional<Point> point_of_six(std::string_view text, AngleKind kind) {
  std::vector<double> numbers;
  while (numbers.size() < 6) {
    while (!text.empty() && (is_space(text.front()) || text.front() == ',')) text.remove_prefix(1);
    const auto number = take_number(text);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  Point point;
  std::copy_n(numbers.begin(), 3, point.place.begin());
  for (std::size_t i = 3; i < 6; ++i) numbers[i] *= std::numbers::pi / 180;
  point.rotation = rotation_by(kind, {numbers.begin() + 3, numbers.end()});
  return point;
}

/// The lines between one that begins so and the next that begins otherwise, with their numbers in the text.
template <class IsPoint>
std::vector<Point> points_in_lines(std::string_view text, std::string_view begin, std::string_view end, AngleKind kind,
                                   IsPoint&& numbers_of) {
  std::vector<Point> points;
  const std::size_t first = text.find(begin);
  for (std::size_t at = first; at != std::string_view::npos && at < text.size();) {
    const std::size_t next = std::min(text.find('\n', at), text.size());
    const std::string_view line = text.substr(at, next - at);
    if (at > first && line.starts_with(end)) break;
    if (auto point = point_of_six(numbers_of(line), kind)) {
      point->line = line_at(text, at);
      points.push_back(*point);
    }
    at = next + 1;
  }
  return points;
}

/// "C00001=430.1,-20.3,..." (or P00001=) of Yaskawa below ///RECTAN: with pulses in place of places nothing is read.
std::vector<Point> rectangular_positions(std::string_view text) {
  return points_in_lines(text, "///RECTAN", "//INST", AngleKind::rpy, [](std::string_view line) {
    const bool is_point = line.size() > 2 && (line[0] == 'C' || line[0] == 'P') && line.find('=') < 12;
    return is_point ? line.substr(line.find('=') + 1) : std::string_view();
  });
}

/// "name x y z o a t" of Kawasaki below .TRANS.
std::vector<Point> transformations(std::string_view text) {
  return points_in_lines(text, ".TRANS", ".END", AngleKind::zyz, [](std::string_view line) {
    const std::size_t blank = line.find_first_of(" \t");
    return blank == std::string_view::npos || line.starts_with(".") ? std::string_view() : line.substr(blank);
  });
}

struct Program {
  const char* language = nullptr;
  std::vector<Point> points;
};

bool has(std::string_view text, std::string_view word) { return text.find(word) != std::string_view::npos; }

Program program_of(std::string_view text) {
  if (has(text, "E6POS ") || has(text, "DEFDAT "))
    return {"KRL of KUKA", points_in_braces(text, {"A", "B", "C"}, AngleKind::zyx)};
  if (has(text, "robtarget ")) return {"RAPID of ABB", robtargets(text)};
  if (has(text, "/POS") && has(text, "P["))
    return {"TP of Fanuc", points_in_braces(text, {"W", "P", "R"}, AngleKind::rpy)};
  if (has(text, "/JOB") && has(text, "///RECTAN")) return {"INFORM of Yaskawa", rectangular_positions(text)};
  if (has(text, "\n.TRANS") || text.starts_with(".TRANS")) return {"AS of Kawasaki", transformations(text)};
  return {};
}

}  // namespace

std::optional<Table> program_points(std::string_view text, const std::string& file) {
  const Program program = program_of(text);
  if (program.points.empty()) return std::nullopt;
  Table table;
  table.file = file;
  table.has_header = true;
  for (const char* name : {"x", "y", "z"}) table.columns.push_back({name, "mm"});
  for (const char* name : {"qx", "qy", "qz", "qw"}) table.columns.push_back({name, ""});
  for (const Point& point : program.points) {
    const Eigen::Quaterniond q(point.rotation);
    table.rows.push_back({point.place[0], point.place[1], point.place[2], q.x(), q.y(), q.z(), q.w()});
    table.lines.push_back(point.line);
  }
  table.notes.push_back(
      message("{}: {} points of a program in {}, in its order; where nothing was measured at one of them, take it "
              "out.",
              file, program.points.size(), program.language));
  return table;
}

}  // namespace handsight
