// SPDX-License-Identifier: Apache-2.0
// Joint readings from tables.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "base/bounds.h"
#include "base/error.h"
#include "base/letters.h"
#include "base/numbers.h"
#include "base/text.h"
#include "readers/pose_files.h"
#include "readers/texts/cells.h"
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

/// The joint of that name that moves by itself, in capitals or not; -1: there is none, or more than one.
int find_mover(const Robot& robot, const std::string& name) {
  const auto moves = [&](int j) {
    return robot.joints[static_cast<std::size_t>(j)].moves() && !robot.joints[static_cast<std::size_t>(j)].is_mimic();
  };
  if (const int j = find_joint(robot, name); j >= 0 && moves(j)) return j;
  int found = -1;
  for (int j = 0; j < static_cast<int>(robot.joints.size()); ++j) {
    if (!moves(j) || lower_case(robot.joints[static_cast<std::size_t>(j)].name) != lower_case(name)) continue;
    if (found >= 0) return -1;
    found = j;
  }
  return found;
}

/// "joint_1" of "/joint_states/joint_1", as PlotJuggler names columns.
std::string last_part(const std::string& path) { return path.substr(path.rfind('/') + 1); }

/// The robot's joint that a column is of: an exact name counts first.
int joint_of(const TableColumn& column, const Robot& robot) {
  for (const std::string& name : {column.name, bare(column.name), last_part(bare(column.name))})
    if (const int j = find_mover(robot, name); j >= 0) return j;
  // A unit that is part of the name: "wrist_deg" may be a joint's own.
  if (column.unit.empty()) return -1;
  const int whole = find_joint(robot, column.name + "_" + column.unit);
  return whole >= 0 && robot.joints[static_cast<std::size_t>(whole)].moves() ? whole : -1;
}

/// A column's name in two: "j" and 1 of "J1", "joint" and 0 of "joint[0]", "position" and 3 of "position_3".
std::optional<std::pair<std::string, int>> numbered_name(const std::string& column) {
  std::string name = lower_case(last_part(column));
  if (bare(name).find_first_of("0123456789") != 0) name = bare(name);  // "j1_pos", but "position_0" as it is
  while (!name.empty() && (name.back() == ']' || name.back() == ')')) name.pop_back();
  const std::size_t digits = name.find_last_not_of("0123456789") + 1;
  if (digits == 0 || digits == name.size() || name.size() - digits > 2) return std::nullopt;
  const int number = static_cast<int>(parse_integer(name.substr(digits)).value_or(-1));
  name.resize(digits);
  while (!name.empty() && std::string("_.[( -").find(name.back()) != std::string::npos) name.pop_back();
  for (const char* known : {"j",
                            "joint",
                            "q",
                            "a",
                            "axis",
                            "achse",
                            "theta",
                            "th",
                            "position",
                            "pos",
                            "angle",
                            "joint_position",
                            "joint_positions",
                            "actual_q",
                            "target_q",
                            "jt",
                            "joint_angle",
                            "joint_angles",
                            "motor",
                            "positions"})
    if (name == known) return std::pair(name, number);
  return std::nullopt;
}

bool has_column(const Table& t, const std::string& name) {
  return std::any_of(t.columns.begin(), t.columns.end(),
                     [&](const TableColumn& c) { return lower_case(c.name) == name; });
}

/// The robot's joint of each column, -1: of none. Where no column has a joint's name, as many numbered ones as the
/// robot has joints that move ("J1" ... "J6", "q0" ... "q5") are those in its order; `are_numbered` then.
std::vector<int> joints_of_columns(const Table& t, const Robot& robot, bool& are_numbered) {
  std::vector<int> joints;
  for (const TableColumn& column : t.columns) joints.push_back(joint_of(column, robot));
  are_numbered = false;
  if (!t.has_header || std::any_of(joints.begin(), joints.end(), [](int j) { return j >= 0; })) return joints;
  const std::vector<std::string> names = joint_names(robot);
  std::map<std::string, std::map<int, std::size_t>> series;  // column by number
  for (std::size_t c = 0; c < t.width(); ++c)
    if (const auto name = numbered_name(t.columns[c].name)) series[name->first][name->second] = c;
  for (const auto& [prefix, columns] : series) {
    const int first = columns.begin()->first;
    const bool is_whole = columns.size() == names.size() && (first == 0 || first == 1) &&
                          columns.rbegin()->first == first + static_cast<int>(names.size()) - 1;
    const bool may_be_quaternion = prefix == "q" && names.size() <= 4 && has_column(t, "x");
    if (!is_whole || may_be_quaternion || are_numbered) continue;
    for (const auto& [number, column] : columns)
      joints[column] = find_joint(robot, names[static_cast<std::size_t>(number - first)]);
    are_numbered = true;
  }
  return joints;
}

/// Does each number come after the one before it, as times do?
bool ascends(const Table& t, std::size_t column) {
  for (std::size_t r = 1; r < t.rows.size(); ++r)
    if (!(t.rows[r][column] > t.rows[r - 1][column])) return false;
  return true;
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
    if (first && !ascends(t, 0))
      throw InputError(
          message("{}: has one column more than the robot has joints, and no header; the first would be a time, and "
                  "does not ascend. Name the columns with --table-columns \"{} marker\" (a name each; - is left out; "
                  "marker says which point of a tracker a line's measurement is of).",
                  t.file, shortened(fmt::format("{}", fmt::join(names, " ")), 150)));
    if (first) t.columns[0].name = "time";
    for (std::size_t i = 0; i < names.size(); ++i) all.push_back({first + i, find_joint(robot, names[i]), degrees});
    notes.push_back(message("{}: has no header; its columns are taken for {}{}.", t.file, first ? "time " : "",
                            shortened(fmt::format("{}", fmt::join(names, " ")), 300)));
    return all;
  }
  bool are_numbered = false;
  const std::vector<int> joints = joints_of_columns(t, robot, are_numbered);
  for (std::size_t c = 0; c < t.width(); ++c) {
    const int joint = joints[c];
    if (joint < 0) continue;
    for (const Placed& p : all)
      if (p.joint == joint)
        refuse(t.file, 1,
               message("the columns {} and {} are both of joint {}, expected one.", p.column + 1, c + 1,
                       in_quotes(robot.joints[static_cast<std::size_t>(joint)].name)));
    all.push_back({c, joint, degrees || t.columns[c].unit == "deg"});
  }
  if (are_numbered)
    notes.push_back(message("{}: its numbered columns ({} ...) are taken for the robot's joints in their order: {}.",
                            t.file, shortened(t.columns[all.front().column].name),
                            shortened(fmt::format("{}", fmt::join(names, " ")), 300)));
  if (all.empty())
    throw InputError(message("{}: no column has the name of a joint of the robot, which has: {}.", t.file,
                             shortened(fmt::format("{}", fmt::join(names, " ")), 300)));
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

/// Are all readings from -100 to 100?
bool may_be_per_cent(const JointSeries& s) {
  return std::all_of(s.positions.begin(), s.positions.end(),
                     [](const Eigen::VectorXd& q) { return q.cwiseAbs().maxCoeff() <= 100; });
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
            message("{}: joint {} stands at {:.4g}, which in rad is {:.0f} turns: these are degrees{}. Say "
                    "--degrees, or write the unit into the header: \"{} [deg]\".",
                    file, joint.name, angle, angle / (2 * std::numbers::pi),
                    may_be_per_cent(s) ? Message(", or per cent of its range as servos tell it (then name LeRobot's "
                                                 "calibration too)")
                                       : Message(),
                    joint.name));
    }
  }
}

}  // namespace

int joint_columns(const Table& table, const Robot& robot) {
  return static_cast<int>(list_joint_columns(table, robot).size());
}

std::vector<std::size_t> list_joint_columns(const Table& table, const Robot& robot) {
  bool are_numbered = false;
  const std::vector<int> joints = joints_of_columns(table, robot, are_numbered);
  std::vector<std::size_t> columns;
  for (std::size_t c = 0; c < joints.size(); ++c)
    if (joints[c] >= 0) columns.push_back(c);
  return columns;
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
