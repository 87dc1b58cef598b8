// SPDX-License-Identifier: Apache-2.0
// QTM's export (https://docs.qualisys.com, "Motion data (.tsv)", "6DOF data (.tsv)"): a name and its value a line, then
// perhaps a line of the columns' names, and a line a frame, perhaps with its number and time (s) before the rest.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>

#include "base/degrees.h"
#include "base/error.h"
#include "base/numbers.h"
#include "base/text.h"
#include "geometry/rigid.h"
#include "readers/mocap/mocap_cells.h"
#include "readers/mocap/mocap_csv.h"

namespace handsight {
namespace {

using namespace mocap;

constexpr std::size_t of_marker = 3;  // columns: X Y Z
constexpr std::size_t of_body = 16;   // X Y Z Roll Pitch Yaw Residual Rot[0] ... Rot[8]
constexpr std::size_t angles_at = 3, matrix_at = 7;

struct Recording {
  std::map<std::string, std::string> settings;
  Cells names;  // of bodies or markers
  bool has_bodies = false;
  std::vector<Cells> frames;
  std::vector<int> lines;   // theirs, in the file
  std::size_t leading = 0;  // columns before the first thing's
};

/// QTM ends lines with a tab.
Cells without_tail(Cells cells) {
  while (cells.size() > 1 && cells.back().empty()) cells.pop_back();
  return cells;
}

void require_columns(Recording& r, const std::string& file) {
  const std::size_t each = r.has_bodies ? of_body : of_marker, own = each * r.names.size();
  for (std::size_t i = 0; i < r.frames.size(); ++i) {
    const std::size_t leading = r.frames[i].size() - own;
    if (r.frames[i].size() < own || leading > 2 || (i > 0 && leading != r.leading))
      refuse(file, r.lines[i],
             r.has_bodies ? "has not 16 columns for each of BODY_NAMES (X to Rot[8]); export the 6DOF data whole."
                          : "has not three columns for each of MARKER_NAMES; export the 3D data whole.");
    r.leading = leading;
  }
  if (r.names.empty() || r.frames.empty())
    throw InputError(
        message("{}: names no bodies or markers, or has no frames; export the 6D or 3D data from QTM with "
                "its header.",
                file));
}

Recording recording_of(const std::string& text, const std::string& file) {
  Recording r;
  int line = 0;
  for (Cells& all : split_cells(text, '\t')) {
    ++line;
    Cells cells = without_tail(std::move(all));
    if (parse_number(cells.front()) && cells.size() >= of_marker) {
      r.frames.push_back(std::move(cells));
      r.lines.push_back(line);
    } else if (cells.front() == "BODY_NAMES" || cells.front() == "MARKER_NAMES") {
      r.has_bodies = cells.front() == "BODY_NAMES";
      r.names.assign(cells.begin() + 1, cells.end());
    } else if (cells.size() >= 2) {
      r.settings[cells[0]] = cells[1];
    }
  }
  require_columns(r, file);
  return r;
}

/// s; by the column of times, else by the frames' rate.
double time_of(const Recording& r, std::size_t frame, const std::string& file) {
  if (r.leading == 2)
    if (const auto time = parse_number(r.frames[frame][1])) return *time;
  const auto rate = r.settings.find("FREQUENCY");
  const auto hertz = rate == r.settings.end() ? std::nullopt : parse_number(rate->second);
  if (!hertz || !(*hertz > 0))
    throw InputError(message("{}: has neither times nor a FREQUENCY; export it again with its times.", file));
  return static_cast<double>(frame) / *hertz;
}

template <std::size_t N>
std::array<double, N> numbers_at(const Recording& r, std::size_t frame, std::size_t column, const std::string& file) {
  std::array<double, N> numbers{};
  for (std::size_t i = 0; i < N; ++i) {
    const std::string& cell = r.frames[frame][column + i];
    const auto number = cell.empty() ? std::optional(0.0) : parse_number(cell);
    if (!number) refuse(file, r.lines[frame], "holds a cell that is no number.");
    numbers[i] = *number;
  }
  return numbers;
}

template <std::size_t N>
bool is_unseen(const std::array<double, N>& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double n) { return n == 0; });
}

Matrix3 matrix_of(const std::array<double, 9>& by_columns) { return Eigen::Map<const Matrix3>(by_columns.data()); }

/// The nine numbers go down the columns; where roll, pitch and yaw (about x, y, z as they turn) say otherwise, along
/// the rows.
bool go_along_rows(const Recording& r, std::size_t column, const std::string& file) {
  double down = 0, along = 0;
  for (std::size_t f = 0; f < r.frames.size(); ++f) {
    const auto angles = numbers_at<3>(r, f, column + angles_at, file);
    const auto nine = numbers_at<9>(r, f, column + matrix_at, file);
    if (is_unseen(nine)) continue;
    const auto turn = [&](std::size_t i, const Vector3& axis) {
      return Eigen::AngleAxisd(angles[i] / degrees, axis).toRotationMatrix();
    };
    const Matrix3 by_angles = turn(0, Vector3::UnitX()) * turn(1, Vector3::UnitY()) * turn(2, Vector3::UnitZ());
    down = std::max(down, (matrix_of(nine) - by_angles).norm());
    along = std::max(along, (matrix_of(nine).transpose() - by_angles).norm());
  }
  constexpr double rounding = 1e-3;
  return along < rounding && down > 10 * rounding;
}

/// x y z qx qy qz qw of one body.
MocapBody body_of(const Recording& r, std::size_t body, const std::string& file) {
  const std::size_t column = r.leading + of_body * body;
  const bool is_transposed = go_along_rows(r, column, file);
  std::vector<Cells> lines;
  for (std::size_t f = 0; f < r.frames.size(); ++f) {
    Cells& cells = lines.emplace_back(Cells{format_number(time_of(r, f, file))});
    const auto nine = numbers_at<9>(r, f, column + matrix_at, file);
    if (is_unseen(nine)) continue;
    const Matrix3 rotation = is_transposed ? Matrix3(matrix_of(nine).transpose()) : matrix_of(nine);
    const Eigen::Quaterniond q(rotation);
    for (const double n : numbers_at<3>(r, f, column, file)) cells.push_back(format_number(n));
    for (const double n : {q.x(), q.y(), q.z(), q.w()}) cells.push_back(format_number(n));
  }
  const std::vector<Column> columns{{1, "x", "mm"}, {2, "y", "mm"}, {3, "z", "mm"}, {4, "qx", ""},
                                    {5, "qy", ""},  {6, "qz", ""},  {7, "qw", ""}};
  return {r.names[body], read_table_lines(lines, 0, lines.size(), 0, 1, columns, file)};
}

Table markers_of(const Recording& r, const std::string& file) {
  std::vector<Cells> lines;
  std::vector<Column> columns;
  for (std::size_t m = 0; m < r.names.size(); ++m)
    for (std::size_t axis = 0; axis < 3; ++axis)
      columns.push_back({1 + of_marker * m + axis, r.names[m] + "_" + "xyz"[axis], "mm"});
  for (std::size_t f = 0; f < r.frames.size(); ++f) {
    Cells& cells = lines.emplace_back(Cells{format_number(time_of(r, f, file))});
    for (std::size_t m = 0; m < r.names.size(); ++m) {
      const auto place = numbers_at<3>(r, f, r.leading + of_marker * m, file);
      for (const double n : place) cells.push_back(is_unseen(place) ? "" : format_number(n));
    }
  }
  return read_table_lines(lines, 0, lines.size(), 0, 1, columns, file);
}

}  // namespace

bool is_qualisys_tsv(const std::string& text) {
  const std::string_view begin = std::string_view(text).substr(0, 2000);
  const bool is_named = begin.starts_with("NO_OF_FRAMES\t") || begin.starts_with("FILE_VERSION\t");
  return is_named && begin.find("\nDATA_INCLUDED\t") != std::string_view::npos;
}

MocapTables read_qualisys_tsv(const std::string& text, const std::string& file) {
  const Recording r = recording_of(text, file);
  MocapTables all;
  if (!r.has_bodies) {
    all.markers = markers_of(r, file);
    return all;
  }
  for (std::size_t body = 0; body < r.names.size(); ++body) all.bodies.push_back(body_of(r, body, file));
  return all;
}

}  // namespace handsight
