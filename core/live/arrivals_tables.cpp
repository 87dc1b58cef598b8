// SPDX-License-Identifier: Apache-2.0
// What arrives in tables: poses, and points of a tracker or poses of a target.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>

#include "base/bounds.h"
#include "base/numbers.h"
#include "base/text.h"
#include "live/arrivals.h"
#include "session/pose_points.h"

namespace handsight {
namespace {

using Cells = GrowingTable::Cells;

std::vector<std::string> pose_columns() { return {"x", "y", "z", "qx", "qy", "qz", "qw"}; }

/// A whole number, also as programs of numbers write it: 12.0.
std::optional<std::int64_t> number_in(const GrowingTable& table, const Cells& cells) {
  const std::string& text = table.cell(cells, "number");
  if (const auto whole = parse_integer(text)) return whole;
  const auto number = parse_number(text);
  if (!number || *number != std::floor(*number) || !(std::abs(*number) < 1e15)) return std::nullopt;
  return static_cast<std::int64_t>(*number);
}

/// The finite numbers of these columns within the bounds; nothing where one is missing.
std::optional<Eigen::VectorXd> numbers_in(const GrowingTable& table, const Cells& cells,
                                          const std::vector<std::string>& columns, const Bounds& within) {
  Eigen::VectorXd numbers(static_cast<Eigen::Index>(columns.size()));
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const auto value = parse_number(table.cell(cells, columns[i]));
    if (!value || !within.hold(*value)) return std::nullopt;
    numbers[static_cast<Eigen::Index>(i)] = *value;
  }
  return numbers;
}

/// x y z and a quaternion of length 1; nothing where they are not there.
std::optional<Rigid> rigid_in(const GrowingTable& table, const Cells& cells) {
  constexpr double off = 0.01;  // of a quaternion's length
  const auto numbers = numbers_in(table, cells, pose_columns(), bounds::length);
  if (!numbers || !(std::abs(numbers->tail<4>().norm() - 1) < off)) return std::nullopt;
  const Eigen::Quaterniond turn(Eigen::Vector4d(numbers->tail<4>()));
  return Rigid{turn.normalized().toRotationMatrix(), numbers->head<3>()};
}

Message find_line(const GrowingTable& table, std::int64_t number) {
  return message("The line of number {} of {}", number, table.name());
}

/// By numbers points and poses are paired.
void require_numbers(GrowingTable& table) {
  table.set_aside(verbatim(table.name()),
                  "its first line names no column `number`, by which poses and measurements are paired");
}

}  // namespace

/// The joints' values, or those that stand for the flange's pose; nothing where they or the time are not whole.
std::optional<Arrivals::Pose> Arrivals::pose_in(const Cells& cells) const {
  Pose pose;
  if (table_.has("time")) {
    pose.time = parse_number(table_.cell(cells, "time"));
    if (!pose.time || !bounds::time.hold(*pose.time)) return std::nullopt;
  }
  if (is_of_flange_ && table_.has("qx")) {
    const auto flange = rigid_in(table_, cells);
    if (!flange) return std::nullopt;
    pose.position = make_position(*flange);
    return pose;
  }
  const auto angles = numbers_in(table_, cells, joints_, bounds::joint);
  if (!angles) return std::nullopt;
  pose.position = *angles;
  return pose;
}

/// Says what is missing.
bool Arrivals::has_all_columns() {
  if (!table_.has_columns()) return false;
  if (cameras_.empty() && !table_.has("number")) {
    require_numbers(table_);
    return false;
  }
  const bool is_flange = is_of_flange_ && table_.has("qx");
  for (const std::string& column : is_flange ? pose_columns() : joints_)
    if (!table_.has(column)) {
      table_.set_aside(verbatim(table_.name()), message("its first line names no column {}", in_quotes(column)));
      return false;
    }
  return true;
}

void Arrivals::take_poses() {
  const GrowingTable::News news = table_.read();
  if (news.is_anew) {
    poses_.clear();
    lines_.clear();
  }
  if (!has_all_columns()) return;
  const char* const why = is_of_flange_ ? "it has no whole pose of the flange (x y z qx qy qz qw)"
                                        : "it has not a finite number for each joint of the session";
  for (const Cells& cells : news.lines) {
    auto pose = pose_in(cells);
    if (!table_.has("number")) {
      lines_.push_back(std::move(pose));
      if (!lines_.back() && !cells.empty())
        table_.set_aside(message("Line {} of {}", lines_.size(), table_.name()), why);
      continue;
    }
    if (cells.empty()) continue;
    const std::string& text = table_.cell(cells, "number");
    const Message part = message("A line of {} (number {})", table_.name(),
                                 text.empty() ? Message("missing") : verbatim(shortened(text)));
    const auto number = number_in(table_, cells);
    if (!number || !pose) {
      table_.set_aside(part, why);
      continue;
    }
    table_.mend(part);
    if (!(pose->time && holds(known_lines_, bits_of_line(*pose->time, pose->position))))
      poses_[*number] = std::move(*pose);
  }
}

void Arrivals::take_points() {
  const GrowingTable::News news = measured_.read();
  if (news.is_anew) points_.clear();
  if (measured_.has_columns() && !measured_.has("number")) require_numbers(measured_);
  for (const Cells& cells : news.lines) {
    const auto number = number_in(measured_, cells);
    if (!number) continue;
    std::vector<Sighting> seen;
    for (int m = 0; m < markers_; ++m) {
      const auto point =
          numbers_in(measured_, cells, {fmt::format("m{}_x", m), fmt::format("m{}_y", m), fmt::format("m{}_z", m)},
                     bounds::length);
      if (point) seen.push_back({.marker = m, .point = Vector3(*point)});
    }
    const Message part = find_line(measured_, *number);
    if (seen.empty()) {
      measured_.set_aside(part, "it has no whole point");
      continue;
    }
    measured_.mend(part);
    points_[*number] = std::move(seen);
  }
}

void Arrivals::take_target_poses() {
  const GrowingTable::News news = measured_.read();
  if (news.is_anew) target_poses_.clear();
  if (measured_.has_columns() && !measured_.has("number")) require_numbers(measured_);
  for (const Cells& cells : news.lines) {
    const auto number = number_in(measured_, cells);
    if (!number) continue;
    const Message part = find_line(measured_, *number);
    if (const auto pose = rigid_in(measured_, cells)) {
      measured_.mend(part);
      target_poses_[*number] = *pose;
    } else {
      measured_.set_aside(part, "it has no finite x y z and no qx qy qz qw of length 1");
    }
  }
}

/// What was measured is then no longer kept. False where it is not there yet.
bool Arrivals::add_measured(std::int64_t number, Observation& o) {
  if (tells_poses_) {
    const auto pose = target_poses_.extract(number);
    if (pose.empty()) return false;
    o.target_pose = pose.mapped();
    show_pose(o, lever_);
    return true;
  }
  auto points = points_.extract(number);
  if (points.empty()) return false;
  o.sightings = std::move(points.mapped());
  return true;
}

void Arrivals::pair_measured(Look& look) {
  for (auto waiting = poses_.begin(); waiting != poses_.end();) {
    Observation o;
    o.position = waiting->second.position;
    if (!add_measured(waiting->first, o)) {
      ++waiting;
      continue;
    }
    const auto [number, pose] = std::move(*waiting);
    waiting = poses_.erase(waiting);
    const std::uint64_t bits = bits_of_measured(o, number);
    if (holds(known_measured_, bits_of_measured(o)) || holds(arrived_, bits)) continue;
    put_into(arrived_, bits);
    arrive(std::move(o), pose, look);
  }
}

}  // namespace handsight
