// SPDX-License-Identifier: Apache-2.0
#include "readers/csv.h"

#include <algorithm>
#include <optional>

#include "base/bounds.h"
#include "base/error.h"
#include "base/files.h"
#include "base/numbers.h"
#include "base/text.h"
#include "readers/texts/cells.h"

namespace handsight {

namespace {

using CsvCells = std::vector<std::string_view>;

/// Where each joint's number stands in a line of so many cells.
struct Columns {
  std::vector<std::size_t> of_joint;
  std::vector<std::optional<std::size_t>> of_velocity;  // per joint; empty: there are none
  std::optional<std::size_t> of_time;
  std::size_t count = 0;
};

Columns plain_columns(std::size_t joints) {
  Columns columns{std::vector<std::size_t>(joints), {}, {}, joints};
  for (std::size_t i = 0; i < joints; ++i) columns.of_joint[i] = i;
  return columns;
}

/// The column of that name, which may stand once.
std::optional<std::size_t> find_column(const std::vector<std::string>& names, const std::string& name,
                                       const std::string& file, int line) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  if (std::find(found + 1, names.end(), name) != names.end())
    refuse(file, line, message("the header names {} twice, expected each column once.", in_quotes(name)));
  return static_cast<std::size_t>(found - names.begin());
}

Columns read_header(const CsvCells& cells, const std::string& file, int line, const std::vector<std::string>& joints,
                    bool with_motion, std::vector<Message>* notes) {
  Columns columns{{}, {}, {}, cells.size()};
  std::vector<std::string> names;
  for (const std::string_view cell : cells) names.emplace_back(unquoted(cell));
  std::size_t known = joints.size();
  for (const std::string& joint : joints) {
    const auto column = find_column(names, joint, file, line);
    if (!column)
      refuse(file, line,
             message("the header has no column {}, expected one for each joint of the session.", in_quotes(joint)));
    columns.of_joint.push_back(*column);
    if (!with_motion) continue;
    columns.of_velocity.push_back(find_column(names, "velocity_" + joint, file, line));
    known += columns.of_velocity.back() ? 1 : 0;
  }
  if (known == joints.size()) columns.of_velocity.clear();
  if (with_motion) columns.of_time = find_column(names, "time", file, line);
  known += columns.of_time ? 1 : 0;
  if (notes && names.size() > known)
    notes->push_back(message("{}: {} columns are no joints of the session and are ignored.", shortened(file, 80),
                             names.size() - known));
  return columns;
}

double read_cell(const CsvCells& cells, std::size_t column, const Bounds& within, const std::string& file, int line) {
  const std::string_view cell = cells[column];
  const std::optional<double> number = parse_number(cell);
  if (!number)
    refuse(file, line,
           message("{} stands in column {}, expected a finite number such as 0.5.", in_quotes(cell), column + 1));
  if (!within.hold(*number))
    refuse(file, line,
           message("{} stands in column {}, expected a number from {:g} to {:g}.", in_quotes(cell), column + 1,
                   within.lowest, within.highest));
  return *number;
}

void read_line(const CsvCells& cells, const std::string& file, int line, const Columns& columns, PoseTable& table) {
  if (cells.size() != columns.count)
    refuse(file, line, message("the line has {} columns, expected {}.", cells.size(), columns.count));
  const auto count = static_cast<Eigen::Index>(columns.of_joint.size());
  Eigen::VectorXd pose(count), velocity = Eigen::VectorXd::Zero(count);
  for (std::size_t i = 0; i < columns.of_joint.size(); ++i)
    pose[static_cast<Eigen::Index>(i)] = read_cell(cells, columns.of_joint[i], bounds::joint, file, line);
  table.positions.push_back(std::move(pose));
  if (columns.of_time) table.times.push_back(read_cell(cells, *columns.of_time, bounds::time, file, line));
  if (columns.of_velocity.empty()) return;
  for (std::size_t i = 0; i < columns.of_velocity.size(); ++i)
    if (const auto column = columns.of_velocity[i])
      velocity[static_cast<Eigen::Index>(i)] = read_cell(cells, *column, bounds::joint, file, line);
  table.velocities.push_back(std::move(velocity));
}

PoseTable parse_table(const std::string& text, const std::string& file, const std::vector<std::string>& joints,
                      bool with_motion, std::vector<Message>* notes) {
  std::string_view rest = text;
  if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);  // the byte order mark of spreadsheet programs
  std::optional<Columns> columns;
  PoseTable table;
  for (int line = 1; !rest.empty(); ++line) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    CsvCells cells = cells_of_line(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (cells.empty()) continue;
    if (cells.back().empty()) cells.pop_back();  // many programs end each line with a separator
    if (!columns && names_columns(cells)) {
      columns = read_header(cells, file, line, joints, with_motion, notes);
      continue;
    }
    if (!columns) columns = plain_columns(joints.size());
    read_line(cells, file, line, *columns, table);
  }
  if (table.positions.empty())
    refuse(file, 0, "there is no pose in the file, expected a line of joint positions for each.");
  return table;
}

}  // namespace

std::vector<std::string_view> cells_of_line(std::string_view line) {
  line = line.substr(0, line.find('#'));
  if (split_words(line).empty()) return {};
  const char separator = cell_separator(line);
  const bool is_comma = separator == '\t' && line.find(',') != std::string_view::npos;  // with tabs for white space
  return cell_views(line, is_comma ? ',' : separator == '\t' ? ' ' : separator);
}

bool names_columns(const std::vector<std::string_view>& cells) {
  return std::none_of(cells.begin(), cells.end(), [](std::string_view cell) { return parse_number(cell).has_value(); });
}

PoseTable parse_pose_table(const std::string& text, const std::string& file, const std::vector<std::string>& joints,
                           std::vector<Message>* notes) {
  return parse_table(text, file, joints, true, notes);
}

PoseTable read_pose_table(const std::filesystem::path& path, const std::vector<std::string>& joints,
                          std::vector<Message>* notes) {
  return parse_pose_table(read_file(path), path.filename().string(), joints, notes);
}

std::vector<Eigen::VectorXd> parse_poses(const std::string& text, const std::string& file,
                                         const std::vector<std::string>& joints, std::vector<Message>* notes) {
  return parse_table(text, file, joints, false, notes).positions;
}

std::vector<Eigen::VectorXd> read_poses(const std::filesystem::path& path, const std::vector<std::string>& joints,
                                        std::vector<Message>* notes) {
  return parse_poses(read_file(path), path.filename().string(), joints, notes);
}

}  // namespace handsight
