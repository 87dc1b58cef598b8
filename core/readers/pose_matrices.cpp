// SPDX-License-Identifier: Apache-2.0
#include "readers/pose_matrices.h"

#include <algorithm>
#include <cctype>
#include <map>

#include "base/error.h"
#include "base/files.h"
#include "base/numbers.h"
#include "base/text.h"
#include "readers/opencv_storage.h"
#include "readers/pose_list.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_pose = 4000;  // bytes of a file with one pose

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// A name without its last number, and the number; nothing where it has none.
struct Numbered {
  std::string name;
  std::int64_t number = 0;
};
std::optional<Numbered> numbered(const std::string& name) {
  std::size_t end = name.size();
  while (end > 0 && !is_digit(name[end - 1])) --end;
  std::size_t begin = end;
  while (begin > 0 && is_digit(name[begin - 1]) && end - begin < 15) --begin;
  if (begin == end) return std::nullopt;
  return Numbered{name.substr(0, begin) + name.substr(end), std::stoll(name.substr(begin, end - begin))};
}

/// All numbers of a text without any other word; nothing where it has one.
std::optional<std::vector<double>> only_numbers(const std::string& text) {
  std::string plain = text;
  for (char& c : plain)
    if (std::string_view("[](),;\r\n\t").find(c) != std::string_view::npos) c = ' ';
  std::vector<double> numbers;
  for (const std::string_view word : split_words(plain)) {
    const auto number = parse_number(std::string(word));
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

Rigid of_place_and_vector(const std::vector<double>& n) {
  return {rotation_from_vector<double>(Vector3(n[3], n[4], n[5])), Vector3(n[0], n[1], n[2])};
}

/// "rows: 6, cols: 1, data: ..." of ViSP, or a matrix that YAML holds.
std::optional<Rigid> pose_of_yaml(const YAML::Node& yaml) {
  if (auto pose = find_pose(yaml, "", 0)) return pose;
  const auto numbers = yaml.IsMap() && yaml["data"] ? yaml_numbers(yaml["data"]) : std::nullopt;
  if (!numbers) return std::nullopt;
  if (numbers->size() == 6) return of_place_and_vector(*numbers);
  return rigid_of_numbers(*numbers);
}

std::optional<Rigid> pose_of_entries(const std::map<std::string, StorageEntry>& entries) {
  std::optional<Rigid> only;
  for (const auto& [name, entry] : entries) {
    const auto pose = entry.rows == 4 && entry.cols == 4 ? rigid_of_numbers(entry.numbers) : std::nullopt;
    if (!pose) continue;
    if (only) return std::nullopt;
    only = pose;
  }
  return only;
}

/// By number, of each name.
using Groups = std::map<std::string, std::map<std::int64_t, Rigid>>;

std::vector<ReadPoses> series_of(const Groups& groups, const std::string& what, std::vector<Message>& notes) {
  std::vector<ReadPoses> all;
  for (const auto& [name, poses] : groups) {
    ReadPoses& read = all.emplace_back();
    read.role = name;
    for (const auto& [number, pose] : poses) {
      read.series.poses.push_back(pose);
      read.series.numbers.push_back(static_cast<double>(number));
    }
    bring_to_metres(read.series, what, notes);
  }
  return all;
}

bool is_matrix(const StorageEntry& e, int rows, int cols) { return e.rows == rows && e.cols == cols; }

/// "R_gripper2base_01" and "t_gripper2base_01".
void add_rotations_and_places(const std::map<std::string, StorageEntry>& entries, Groups& groups) {
  for (const auto& [name, entry] : entries) {
    const auto at = numbered(name);
    if (!at || !is_matrix(entry, 3, 3) || (name[0] != 'R' && name[0] != 'r')) continue;
    for (const char* first : {"t", "T"}) {
      const auto place = entries.find(first + name.substr(1));
      if (place == entries.end() || place->second.numbers.size() != 3) continue;
      const auto& r = entry.numbers;
      const auto& t = place->second.numbers;
      if (const auto pose = rigid_of_numbers({r[0], r[1], r[2], t[0], r[3], r[4], r[5], t[1], r[6], r[7], r[8], t[2]}))
        groups[at->name.substr(1)][at->number] = *pose;
    }
  }
}

}  // namespace

std::optional<Rigid> single_pose(const std::string& text) {
  if (text.size() > longest_pose) return std::nullopt;
  try {
    if (const auto numbers = only_numbers(text)) return rigid_of_numbers(*numbers);
    const bool is_storage = text.starts_with("%YAML") || text.find("opencv") != std::string::npos;
    return is_storage ? pose_of_entries(parse_opencv_storage(text, "")) : pose_of_yaml(parse_yaml(text, ""));
  } catch (const InputError&) {
    return std::nullopt;
  }
}

std::vector<fs::path> pose_files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    std::error_code is_gone;
    if (!entry.is_regular_file(is_gone) || entry.file_size(is_gone) > longest_pose) continue;
    if (numbered(entry.path().stem().string()) && single_pose(read_file(entry.path()))) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<ReadPoses> read_pose_files(const std::vector<fs::path>& files, const std::string& what,
                                       std::vector<Message>& notes) {
  Groups groups;
  for (const fs::path& file : files) {
    const auto at = numbered(file.stem().string());
    const auto pose = single_pose(read_file(file));
    if (!at || !pose)
      throw InputError(
          message("{}: holds no single pose, or has no number in its name; expected a 4x4 matrix.", shown_path(file)));
    if (!groups[at->name].emplace(at->number, *pose).second)
      throw InputError(message("{}: another file of poses has the number {} too; expected one for each instant.",
                               shown_path(file), at->number));
  }
  return series_of(groups, what, notes);
}

std::vector<ReadPoses> poses_of_storage(const std::string& text, const std::string& file, std::vector<Message>& notes) {
  Groups groups;
  const auto entries = parse_opencv_storage(text, file);
  for (const auto& [name, entry] : entries) {
    const auto at = numbered(name);
    const auto pose = at && is_matrix(entry, 4, 4) ? rigid_of_numbers(entry.numbers) : std::nullopt;
    if (pose) groups[at->name][at->number] = *pose;
  }
  add_rotations_and_places(entries, groups);
  std::erase_if(groups, [](const auto& group) { return group.second.size() < 2; });
  return series_of(groups, file, notes);
}

}  // namespace handsight
