// SPDX-License-Identifier: Apache-2.0
#include "ways/arrivals.h"

#include <algorithm>
#include <cctype>
#include <fstream>

#include "base/error.h"
#include "base/files.h"
#include "base/numbers.h"
#include "base/text.h"
#include "vision/image_file.h"
#include "vision/image_header.h"

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
      is_tracker_(session.is_tracker()),
      markers_(session.marker_count),
      joint_lines_{"joints.csv"},
      point_lines_{"points.csv"} {
  for (const Observation& o : session.observations) {
    for (const std::string& image : o.images)
      if (!image.empty()) known_files_.insert(image);
    know_time(known_times_, o.time);
    next_time_ = std::max(next_time_, o.time + 1);
  }
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

void Arrivals::take_joints(Look& look) {
  for (const std::vector<std::string>& cells : new_lines(joint_lines_, look)) {
    const auto& columns = joint_lines_.columns;
    const auto number_at = place_of(columns, "number"), time_at = place_of(columns, "time");
    const auto number = number_at ? parse_integer(cells[*number_at]) : std::nullopt;
    Pose pose{Eigen::VectorXd(static_cast<Eigen::Index>(joints_.size())), next_time_};
    bool is_good = number.has_value();
    for (std::size_t j = 0; j < joints_.size() && is_good; ++j) {
      const auto at = place_of(columns, joints_[j]);
      const auto value = at ? parse_number(cells[*at]) : std::nullopt;
      is_good = value && bounds::joint.hold(*value);
      if (is_good) pose.position[static_cast<Eigen::Index>(j)] = *value;
    }
    if (time_at && is_good) {
      const auto time = parse_number(cells[*time_at]);
      is_good = time.has_value();
      if (is_good) pose.time = *time;
    }
    if (is_good && !(time_at && std::binary_search(known_times_.begin(), known_times_.end(), pose.time)))
      poses_[*number] = pose;
    else if (!is_good)
      set_aside(fmt::format("A line of {} (number {})", joint_lines_.file,
                            number_at ? shortened(cells[*number_at]) : std::string("missing")),
                "it has not a finite number for each joint of the session", look);
  }
}

void Arrivals::take_points(Look& look) {
  for (const std::vector<std::string>& cells : new_lines(point_lines_, look)) {
    const auto number_at = place_of(point_lines_.columns, "number");
    const auto number = number_at ? parse_integer(cells[*number_at]) : std::nullopt;
    if (!number) continue;
    std::vector<Sighting> seen;
    for (int m = 0; m < markers_; ++m) {
      Vector3 point;
      bool is_whole = true;
      for (int i = 0; i < 3; ++i) {
        const auto at = place_of(point_lines_.columns, fmt::format("m{}_{}", m, "xyz"[i]));
        const auto value = at ? parse_number(cells[*at]) : std::nullopt;
        is_whole = is_whole && value && bounds::length.hold(*value);
        if (is_whole) point[i] = *value;
      }
      if (is_whole) seen.push_back({.marker = m, .point = point});
    }
    if (seen.empty())
      set_aside(fmt::format("The line of number {} of {}", *number, point_lines_.file), "it has no whole point", look);
    else
      points_[*number] = std::move(seen);
  }
}

void Arrivals::take_images(Look&) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder_ / "images", error)) {
    const std::string name = entry.path().filename().string(), file = "images/" + name;
    if (name.starts_with(".") || known_files_.count(file)) continue;
    const std::int64_t number = number_of(entry.path().stem().string());
    const std::string stem = lower(entry.path().stem().string());
    const bool left = stem.find("left") != std::string::npos, right = stem.find("right") != std::string::npos;
    if (number < 0 || left == right) continue;
    images_[number][left ? 0 : 1] = file;
  }
}

bool Arrivals::add_images(std::int64_t number, Observation& o, Look& look) {
  const auto found = images_.find(number);
  if (found == images_.end() || found->second[0].empty() || found->second[1].empty()) return false;
  for (std::size_t side = 0; side < 2; ++side) {
    const std::string& file = found->second[side];
    if (is_whole(folder_ / file)) {
      o.images[side] = file;
      continue;
    }
    const auto now = std::chrono::steady_clock::now();
    if (now - half_since_.emplace(file, now).first->second > patience)
      set_aside(file, "it is no whole image two seconds after it appeared; it comes in when it is written again", look);
    return false;
  }
  return true;
}

Arrivals::Look Arrivals::look() {
  Look look;
  take_joints(look);
  if (is_tracker_)
    take_points(look);
  else
    take_images(look);
  for (auto pose = poses_.begin(); pose != poses_.end();) {
    Observation o;
    o.position = pose->second.position;
    o.time = pose->second.time;
    const auto points = points_.find(pose->first);
    bool is_there = is_tracker_ ? points != points_.end() : add_images(pose->first, o, look);
    if (!is_there) {
      ++pose;
      continue;
    }
    if (is_tracker_) {
      o.sightings = std::move(points->second);
      points_.erase(points);
    } else {
      known_files_.insert(o.images.begin(), o.images.begin() + 2);
      half_since_.erase(o.images[0]);
      half_since_.erase(o.images[1]);
      images_.erase(pose->first);
    }
    know_time(known_times_, o.time);
    next_time_ = std::max(next_time_, o.time + 1);
    look.arrived.push_back(std::move(o));
    pose = poses_.erase(pose);
  }
  return look;
}

}  // namespace handsight
