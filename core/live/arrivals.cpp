// SPDX-License-Identifier: Apache-2.0
#include "live/arrivals.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <fstream>

#include "base/error.h"
#include "base/files.h"
#include "base/numbers.h"
#include "base/text.h"
#include "session/pose_points.h"
#include "vision/image/image_file.h"
#include "vision/image/image_header.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds patience{2};

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells{""};
  for (const char c : line) {
    if (c == ',' || c == ';')
      cells.emplace_back();
    else if (c != ' ' && c != '\r' && c != '\t' && c != '"')
      cells.back() += c;
  }
  return cells;
}

/// The last number in a file's name, -1 where there is none.
std::int64_t number_of(const std::string& name) {
  std::size_t end = name.size();
  while (end > 0 && !std::isdigit(static_cast<unsigned char>(name[end - 1]))) --end;
  std::size_t begin = end;
  while (begin > 0 && end - begin < 15 && std::isdigit(static_cast<unsigned char>(name[begin - 1]))) --begin;
  return begin == end ? -1 : std::stoll(name.substr(begin, end - begin));
}

std::optional<std::size_t> place_of(const std::vector<std::string>& columns, const std::string& name) {
  const auto found = std::find(columns.begin(), columns.end(), name);
  if (found == columns.end()) return std::nullopt;
  return static_cast<std::size_t>(found - columns.begin());
}

std::optional<std::int64_t> whole_number(const std::vector<std::string>& columns,
                                         const std::vector<std::string>& cells) {
  const auto at = place_of(columns, "number");
  return at ? parse_integer(cells[*at]) : std::nullopt;
}

/// The finite numbers of these columns, of lengths or less; nothing where one is missing.
template <int n>
std::optional<Eigen::Matrix<double, n, 1>> numbers_of(const std::vector<std::string>& columns,
                                                      const std::vector<std::string>& cells,
                                                      const std::array<std::string, n>& names) {
  Eigen::Matrix<double, n, 1> numbers;
  for (int i = 0; i < n; ++i) {
    const auto at = place_of(columns, names[static_cast<std::size_t>(i)]);
    const auto value = at ? parse_number(cells[*at]) : std::nullopt;
    if (!value || !bounds::length.hold(*value)) return std::nullopt;
    numbers[i] = *value;
  }
  return numbers;
}

/// x y z and a quaternion of length 1; nothing where they are not there.
std::optional<Rigid> pose_in(const std::vector<std::string>& columns, const std::vector<std::string>& cells) {
  constexpr double off = 0.01;  // of a quaternion's length
  const auto place = numbers_of<3>(columns, cells, {"x", "y", "z"});
  const auto turn = numbers_of<4>(columns, cells, {"qx", "qy", "qz", "qw"});
  if (!place || !turn || !(std::abs(turn->norm() - 1) < off)) return std::nullopt;
  return Rigid{Eigen::Quaterniond(*turn).normalized().toRotationMatrix(), *place};
}

/// Nearly always the latest.
void know_time(std::vector<double>& ascending, double time) {
  ascending.insert(std::upper_bound(ascending.begin(), ascending.end(), time), time);
}

bool is_whole(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  return image_size(bytes).has_value() && !is_cut_off(bytes);
}

}  // namespace

Arrivals::Arrivals(const Session& session)
    : folder_(folder(session)),
      joints_(session.joints),
      tells_poses_(session.pose_sensor.has_value()),
      is_of_flange_(session.robot.is_of_poses),
      markers_(session.marker_count),
      joint_lines_{"joints.csv"},
      measured_lines_{session.pose_sensor ? "poses.csv" : "points.csv"} {
  if (session.rig)
    for (const std::string& name : camera_names(*session.rig)) cameras_.push_back(lower(name));
  if (session.pose_sensor) lever_ = pose_lever(*session.pose_sensor);
  for (const Observation& o : session.observations) {
    for (const std::string& image : o.images)
      if (!image.empty()) known_files_.insert(image);
    know_time(known_times_, o.time);
    next_time_ = std::max(next_time_, o.time + 1);
    if (!session.rig) known_measured_.insert(key_of(o));
  }
}

Arrivals::Key Arrivals::key_of(const Observation& o) {
  Key key;
  const auto add = [&key](double x) { key.push_back(std::llround(1e9 * x)); };
  for (const double q : o.position) add(q);
  if (o.target_pose) {
    for (const double x : o.target_pose->translation) add(x);
    return key;
  }
  for (const Sighting& s : o.sightings)
    if (s.point)
      for (const double x : *s.point) add(x);
  return key;
}

void Arrivals::set_aside(const std::string& what, const std::string& why, Look& look) {
  if (said_.insert(what).second) look.remarks.push_back(fmt::format("{} is set aside: {}.", what, why));
}

std::vector<std::vector<std::string>> Arrivals::new_lines(Lines& lines, Look& look) {
  std::vector<std::vector<std::string>> found;
  std::error_code error;
  const fs::path path = folder_ / lines.file;
  const auto size = fs::file_size(path, error);
  if (error || size == lines.read) return found;
  if (size < lines.read) lines = {lines.file, 0, {}};  // its writer has begun again
  std::ifstream in(path, std::ios::binary);
  in.seekg(static_cast<std::streamoff>(lines.read));
  std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  const std::size_t end = text.rfind('\n');
  if (end == std::string::npos) return found;
  lines.read += end + 1;
  text.resize(end);
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t stop = std::min(text.find('\n', begin), text.size());
    const std::string line = text.substr(begin, stop - begin);
    begin = stop + 1;
    if (split_words(line).empty() || line[0] == '#') continue;
    std::vector<std::string> cells = cells_of(line);
    if (lines.columns.empty()) {
      lines.columns = std::move(cells);
      if (!place_of(lines.columns, "number"))
        set_aside(lines.file, "its first line names no column `number`, by which poses and measurements are paired",
                  look);
      continue;
    }
    if (cells.size() == lines.columns.size())
      found.push_back(std::move(cells));
    else
      set_aside(fmt::format("The line {} of {}", in_quotes(line, 80), lines.file),
                fmt::format("it has {} columns where the header has {}", cells.size(), lines.columns.size()), look);
  }
  return found;
}

/// The joints' values, or those that stand for the flange's pose; nothing where they are not whole.
std::optional<Eigen::VectorXd> Arrivals::position_in(const std::vector<std::string>& cells) const {
  const auto& columns = joint_lines_.columns;
  if (is_of_flange_ && place_of(columns, "qx")) {
    const auto pose = pose_in(columns, cells);
    return pose ? std::optional<Eigen::VectorXd>(position_of(*pose)) : std::nullopt;
  }
  Eigen::VectorXd position(static_cast<Eigen::Index>(joints_.size()));
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const auto at = place_of(columns, joints_[j]);
    const auto value = at ? parse_number(cells[*at]) : std::nullopt;
    if (!value || !bounds::joint.hold(*value)) return std::nullopt;
    position[static_cast<Eigen::Index>(j)] = *value;
  }
  return position;
}

void Arrivals::take_joints(Look& look) {
  for (const std::vector<std::string>& cells : new_lines(joint_lines_, look)) {
    const auto& columns = joint_lines_.columns;
    const auto number_at = place_of(columns, "number"), time_at = place_of(columns, "time");
    const auto number = whole_number(columns, cells);
    const auto position = position_in(cells);
    const auto time = time_at ? parse_number(cells[*time_at]) : std::optional(next_time_);
    if (!number || !position || !time)
      set_aside(fmt::format("A line of {} (number {})", joint_lines_.file,
                            number_at ? shortened(cells[*number_at]) : std::string("missing")),
                is_of_flange_ ? "it has no whole pose of the flange (x y z qx qy qz qw)"
                              : "it has not a finite number for each joint of the session",
                look);
    else if (!(time_at && std::binary_search(known_times_.begin(), known_times_.end(), *time)))
      poses_[*number] = {*position, *time};
  }
}

void Arrivals::take_points(Look& look) {
  for (const std::vector<std::string>& cells : new_lines(measured_lines_, look)) {
    const auto& columns = measured_lines_.columns;
    const auto number = whole_number(columns, cells);
    if (!number) continue;
    std::vector<Sighting> seen;
    for (int m = 0; m < markers_; ++m) {
      const auto point =
          numbers_of<3>(columns, cells, {fmt::format("m{}_x", m), fmt::format("m{}_y", m), fmt::format("m{}_z", m)});
      if (point) seen.push_back({.marker = m, .point = *point});
    }
    if (seen.empty())
      set_aside(fmt::format("The line of number {} of {}", *number, measured_lines_.file), "it has no whole point",
                look);
    else
      points_[*number] = std::move(seen);
  }
}

void Arrivals::take_poses(Look& look) {
  for (const std::vector<std::string>& cells : new_lines(measured_lines_, look)) {
    const auto& columns = measured_lines_.columns;
    const auto number = whole_number(columns, cells);
    if (!number) continue;
    if (const auto pose = pose_in(columns, cells))
      target_poses_[*number] = *pose;
    else
      set_aside(fmt::format("The line of number {} of {}", *number, measured_lines_.file),
                "it has no finite x y z and no qx qy qz qw of length 1", look);
  }
}

/// The camera that a file's name names; of two names in it the one that the other is part of.
std::optional<std::size_t> Arrivals::camera_of(const std::string& stem) const {
  if (cameras_.size() == 1) return 0;
  std::optional<std::size_t> found;
  for (std::size_t c = 0; c < cameras_.size(); ++c) {
    if (stem.find(cameras_[c]) == std::string::npos) continue;
    if (!found || cameras_[c].find(cameras_[*found]) != std::string::npos)
      found = c;
    else if (cameras_[*found].find(cameras_[c]) == std::string::npos)
      return std::nullopt;
  }
  return found;
}

void Arrivals::take_images() {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder_ / "images", error)) {
    const std::string name = entry.path().filename().string(), file = "images/" + name;
    if (name.starts_with(".") || known_files_.count(file)) continue;
    std::string stem = lower(entry.path().stem().string());
    const auto camera = camera_of(stem);
    if (!camera) continue;
    // A camera's name may end in a number of its own.
    if (const std::size_t at = stem.find(cameras_[*camera]); at != std::string::npos)
      stem = fmt::format("{} {}", stem.substr(0, at), stem.substr(at + cameras_[*camera].size()));
    if (const std::int64_t number = number_of(stem); number >= 0) images_[number][*camera] = file;
  }
}

bool Arrivals::add_images(std::int64_t number, Observation& o, Look& look) {
  const auto found = images_.find(number);
  if (found == images_.end()) return false;
  for (std::size_t c = 0; c < cameras_.size(); ++c)
    if (found->second[c].empty()) return false;
  for (std::size_t c = 0; c < cameras_.size(); ++c) {
    const std::string& file = found->second[c];
    if (is_whole(folder_ / file)) {
      o.images[c] = file;
      continue;
    }
    const auto now = std::chrono::steady_clock::now();
    if (now - half_since_.emplace(file, now).first->second > patience)
      set_aside(file, "it is no whole image two seconds after it appeared; it comes in when it is written again", look);
    return false;
  }
  return true;
}

/// False where it is not there yet.
bool Arrivals::add_measured(std::int64_t number, Observation& o, Look& look) {
  if (!cameras_.empty()) return add_images(number, o, look);
  if (tells_poses_) {
    const auto pose = target_poses_.find(number);
    if (pose == target_poses_.end()) return false;
    o.target_pose = pose->second;
    show_pose(o, lever_);
    return true;
  }
  const auto points = points_.find(number);
  if (points == points_.end()) return false;
  o.sightings = points->second;
  return true;
}

void Arrivals::forget(std::int64_t number, const Observation& o) {
  points_.erase(number);
  target_poses_.erase(number);
  images_.erase(number);
  for (const std::string& image : o.images) {
    if (image.empty()) continue;
    known_files_.insert(image);
    half_since_.erase(image);
  }
}

Arrivals::Look Arrivals::look() {
  Look look;
  take_joints(look);
  if (!cameras_.empty())
    take_images();
  else if (tells_poses_)
    take_poses(look);
  else
    take_points(look);
  for (auto pose = poses_.begin(); pose != poses_.end();) {
    Observation o;
    o.position = pose->second.position;
    o.time = pose->second.time;
    if (!add_measured(pose->first, o, look)) {
      ++pose;
      continue;
    }
    forget(pose->first, o);
    pose = poses_.erase(pose);
    if (!known_measured_.empty() && known_measured_.contains(key_of(o))) continue;
    know_time(known_times_, o.time);
    next_time_ = std::max(next_time_, o.time + 1);
    look.arrived.push_back(std::move(o));
  }
  return look;
}

}  // namespace handsight
