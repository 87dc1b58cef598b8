// SPDX-License-Identifier: Apache-2.0
// Joint readings from tables.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/bounds.h"
#include "base/error.h"
#include "base/text.h"
#include "readers/pose_files.h"
#include "robot/robot.h"

namespace handsight {
namespace {

constexpr double most_of_a_turn = 4 * std::numbers::pi;  // rad: no joint of a robot turns farther

/// Programs put "position" before or after a joint's name.
std::string bare(std::string name) {
  for (const std::string end : {"_position", "_pos", ".position", ".pos", "/position", "_angle", "_q"})
    if (name.size() > end.size() && name.ends_with(end)) return name.substr(0, name.size() - end.size());
  for (const std::string begin : {"position_", "pos_", "position.", "position/", "joint_position_", "angle_", "q_"})
    if (name.size() > begin.size() && name.starts_with(begin)) return name.substr(begin.size());
  return name;
}

/// The robot's joint that a column is of: an exact name counts first.
int joint_of(const TableColumn& column, const Robot& robot) {
  for (const std::string& name : {column.name, bare(column.name)}) {
    const int j = find_joint(robot, name);
    if (j >= 0 && robot.joints[static_cast<std::size_t>(j)].moves() &&
        !robot.joints[static_cast<std::size_t>(j)].is_mimic())
      return j;
  }
  // A unit that is part of the name: "wrist_deg" may be a joint's own.
  if (column.unit.empty()) return -1;
  const int whole = find_joint(robot, column.name + "_" + column.unit);
  return whole >= 0 && robot.joints[static_cast<std::size_t>(whole)].moves() ? whole : -1;
}

struct Placed {
  std::size_t column;
  int joint;
  bool is_degrees;
};

std::vector<Placed> placed(Table& t, const Robot& robot, bool degrees, std::vector<Message>& notes) {
  std::vector<Placed> all;
  const std::vector<std::string> names = joint_names(robot);
  if (!t.has_header) {
    const std::size_t first = t.width() == names.size() + 1 ? 1 : 0;
    if (t.width() - first != names.size())
      throw InputError(
          message("{}: has {} columns and no header, the robot {} joints that move by themselves: {}. "
                  "Write a first line with the columns' names.",
                  t.file, t.width(), names.size(), shortened(fmt::format("{}", fmt::join(names, " ")), 250)));
    if (first) t.columns[0].name = "time";
    for (std::size_t i = 0; i < names.size(); ++i) all.push_back({first + i, find_joint(robot, names[i]), degrees});
    notes.push_back(message("{}: has no header; its columns are taken for {}{}.", t.file, first ? "time " : "",
                            shortened(fmt::format("{}", fmt::join(names, " ")), 300)));
    return all;
  }
  int ignored = 0;
  for (std::size_t c = 0; c < t.width(); ++c) {
    const int joint = joint_of(t.columns[c], robot);
    if (joint < 0) {
      ++ignored;
      continue;
    }
    for (const Placed& p : all)
      if (p.joint == joint)
        refuse(t.file, 1,
               message("the columns {} and {} are both of joint {}, expected one.", p.column + 1, c + 1,
                       in_quotes(robot.joints[static_cast<std::size_t>(joint)].name)));
    all.push_back({c, joint, degrees || t.columns[c].unit == "deg"});
  }
  if (all.empty())
    throw InputError(message("{}: no column has the name of a joint of the robot, which has: {}.", t.file,
                             shortened(fmt::format("{}", fmt::join(names, " ")), 300)));
  const int others = ignored - static_cast<int>(find_column(t, {"time", "timestamp", "t", "stamp"}).has_value());
  if (others > 0)
    notes.push_back(message("{}: {} columns are no joints of the robot and are left out.", t.file, others));
  return all;
}

/// How far a column's values go beyond a joint's limits.
double beyond(const std::vector<Eigen::VectorXd>& positions, Eigen::Index column, const Joint& joint) {
  double most = 0;
  for (const Eigen::VectorXd& q : positions) most = std::max({most, q[column] - joint.upper, joint.lower - q[column]});
  return most;
}

/// Columns that break limits, where another order of the same columns would break none.
void warn_of_order(const JointSeries& s, const std::vector<Placed>& columns, const Robot& robot,
                   const std::string& file, std::vector<Message>& notes) {
  constexpr double slack = 0.05;  // rad (m)
  const auto joint = [&](std::size_t i) -> const Joint& {
    return robot.joints[static_cast<std::size_t>(columns[i].joint)];
  };
  std::string worst;
  double most = slack;
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (const double by = beyond(s.positions, static_cast<Eigen::Index>(i), joint(i)); by > most) {
      most = by;
      worst = joint(i).name;
    }
  if (worst.empty()) return;
  Message hint;
  for (std::size_t i = 0; i < columns.size() && hint.empty(); ++i)
    for (std::size_t k = i + 1; k < columns.size() && hint.empty(); ++k) {
      double left = 0;
      for (std::size_t c = 0; c < columns.size(); ++c)
        left = std::max(left, beyond(s.positions, static_cast<Eigen::Index>(c), joint(c == i ? k : c == k ? i : c)));
      if (left <= slack)
        hint = message(" With {} and {} exchanged all would be within them.", joint(i).name, joint(k).name);
    }
  double reversed = 0;
  for (std::size_t c = 0; c < columns.size(); ++c)
    reversed = std::max(reversed, beyond(s.positions, static_cast<Eigen::Index>(c), joint(columns.size() - 1 - c)));
  if (hint.empty() && reversed <= slack) hint = " In the reverse order all would be within them.";
  notes.push_back(message(
      "{}: joint {} goes {:.2f} {} beyond its limits: are the columns in another order than the "
      "robot's joints, or of another unit?{}",
      file, worst, most,
      robot.joints[static_cast<std::size_t>(find_joint(robot, worst))].kind == JointKind::prismatic ? "m" : "rad",
      hint));
}

void refuse_degrees(const JointSeries& s, const std::vector<Placed>& columns, const Robot& robot,
                    const std::string& file) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const Joint& joint = robot.joints[static_cast<std::size_t>(columns[i].joint)];
    if (joint.kind == JointKind::prismatic || columns[i].is_degrees) continue;
    for (const Eigen::VectorXd& q : s.positions) {
      const double angle = std::abs(q[static_cast<Eigen::Index>(i)]);
      if (angle > most_of_a_turn && beyond(s.positions, static_cast<Eigen::Index>(i), joint) > 0)
        throw InputError(
            message("{}: joint {} stands at {:.4g}, which in rad is {:.0f} turns: these are degrees. Say "
                    "--degrees, or write the unit into the header: \"{} [deg]\".",
                    file, joint.name, angle, angle / (2 * std::numbers::pi), joint.name));
    }
  }
}

}  // namespace

int joint_columns(const Table& table, const Robot& robot) {
  int count = 0;
  for (const TableColumn& c : table.columns) count += joint_of(c, robot) >= 0;
  return count;
}

JointSeries read_joint_table(Table table, const Robot& robot, bool degrees, std::vector<Message>& notes) {
  const std::vector<Placed> columns = placed(table, robot, degrees, notes);
  JointSeries s;
  s.times = list_times(table, notes);
  sort_by_time(table, s.times, notes);
  std::vector<std::size_t> used;
  for (const Placed& p : columns) used.push_back(p.column);
  require_full(table, used);
  for (const Placed& p : columns) s.names.push_back(robot.joints[static_cast<std::size_t>(p.joint)].name);
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    Eigen::VectorXd q(static_cast<Eigen::Index>(columns.size()));
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const Placed& p = columns[i];
      const bool turns = robot.joints[static_cast<std::size_t>(p.joint)].kind != JointKind::prismatic;
      const double unit = turns && p.is_degrees                            ? std::numbers::pi / 180
                          : !turns && table.columns[p.column].unit == "mm" ? 1e-3
                                                                           : 1;
      q[static_cast<Eigen::Index>(i)] = table.rows[r][p.column] * unit;
      if (!bounds::joint.hold(q[static_cast<Eigen::Index>(i)]))
        refuse(table.file, table.lines[r],
               message("joint {} stands at {:g}, expected a number from {:g} to {:g}.", s.names[i],
                       table.rows[r][p.column], bounds::joint.lowest, bounds::joint.highest));
    }
    s.positions.push_back(std::move(q));
  }
  if (std::any_of(columns.begin(), columns.end(), [](const Placed& p) { return p.is_degrees; }))
    notes.push_back(message("{}: angles are read as degrees.", table.file));
  refuse_degrees(s, columns, robot, table.file);
  warn_of_order(s, columns, robot, table.file, notes);
  return s;
}

}  // namespace handsight
