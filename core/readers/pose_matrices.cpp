// SPDX-License-Identifier: Apache-2.0
#include "readers/pose_matrices.h"

#include <algorithm>
#include <cctype>
#include <limits>
#include <map>
#include <numbers>
#include <sstream>

#include "base/error.h"
#include "base/files.h"
#include "base/letters.h"
#include "base/numbers.h"
#include "base/text.h"
#include "geometry/angle_kinds.h"
#include "readers/opencv_storage.h"
#include "readers/pose_list.h"
#include "readers/texts/plain_text.h"
#include "readers/yaml_text.h"

namespace handsight {
namespace {

using NamedPosesOfInstant = std::vector<std::pair<std::string, Rigid>>;
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
  while (begin > 0 && is_digit(name[begin - 1]) && end - begin < 19) --begin;  // ns since 1970 have 19
  if (end - begin == 19 && name[begin] > '8') ++begin;
  if (begin == end) return std::nullopt;
  return Numbered{name.substr(0, begin) + name.substr(end), std::stoll(name.substr(begin, end - begin))};
}

/// All numbers of a text without any other word; nothing where it has one.
std::optional<std::vector<double>> only_numbers(const std::string& text) {
  std::string plain = text;
  for (const char* word : {"numpy.array", "np.array", "array", "matrix"})  // as Python prints them
    for (std::size_t at = plain.find(word); at != std::string::npos; at = plain.find(word))
      plain.erase(at, std::string_view(word).size());
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
  if (yaml.IsMap() && yaml["FloatMatrix"] && yaml["FloatMatrix"]["Data"])  // of Zivid
    return find_pose(yaml["FloatMatrix"]["Data"], "", 0);
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

/// A pose as HALCON's write_pose has it; its types of numbers are those of create_pose ("point" alone).
std::optional<Rigid> pose_of_halcon(const std::string& text) {
  std::map<char, std::vector<double>> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    const auto words = split_words(line);
    if (words.size() < 2 || words[0].size() != 1) continue;
    for (std::size_t i = 1; i < words.size(); ++i)
      lines[words[0][0]].push_back(parse_number(words[i]).value_or(std::numeric_limits<double>::quiet_NaN()));
  }
  const auto &type = lines['f'], &turn = lines['r'], &place = lines['t'];
  if (type.size() != 1 || turn.size() != 3 || place.size() != 3) return std::nullopt;
  constexpr double degree = std::numbers::pi / 180;
  const std::vector<double> angles{turn[0] * degree, turn[1] * degree, turn[2] * degree};
  const std::map<double, AngleKind> kinds{{0, AngleKind::moving_xyz}, {2, AngleKind::rpy}};
  if (type[0] == 4) return Rigid{rotation_from_vector<double>(Vector3(turn.data())), Vector3(place.data())};
  const auto kind = kinds.find(type[0]);
  if (kind == kinds.end()) return std::nullopt;
  return Rigid{rotation_by(kind->second, angles), Vector3(place.data())};
}

/// Without "rvec" and what joins it to the rest: "target" of "target_rvec".
std::string without_word(const std::string& name, const std::string& word) {
  std::string rest = name;
  rest.erase(rest.find(word), word.size());
  while (!rest.empty() && rest.back() == '_') rest.pop_back();
  return rest;
}

/// What a map of one instant holds: poses, and rotation vectors with their places.
NamedPosesOfInstant poses_of_map(const YAML::Node& yaml) {
  NamedPosesOfInstant poses;
  if (!yaml.IsMap()) return poses;
  for (const auto& entry : yaml) {
    if (!entry.first.IsScalar()) continue;
    const std::string name = entry.first.Scalar();
    if (const auto pose = find_pose(entry.second, "", 0)) poses.emplace_back(name, *pose);
    if (name.find("rvec") == std::string::npos) continue;
    std::string place_name = name;
    place_name[name.find("rvec")] = 't';
    const auto turn = yaml_numbers(entry.second), place = yaml_numbers(yaml[place_name]);
    if (turn && place && turn->size() == 3 && place->size() == 3)
      poses.emplace_back(without_word(name, "rvec"),
                         Rigid{rotation_from_vector<double>(Vector3(turn->data())), Vector3(place->data())});
  }
  return poses;
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

namespace {

/// The one pose that a text is as a whole.
std::optional<Rigid> single_pose(const std::string& text) {
  if (const auto numbers = only_numbers(text)) return rigid_of_numbers(*numbers);
  if (text.starts_with("# 3D POSE PARAMETERS")) return pose_of_halcon(text);
  const bool is_storage = text.starts_with("%YAML") || text.find("opencv") != std::string::npos;
  return is_storage ? pose_of_entries(parse_opencv_storage(text, "")) : pose_of_yaml(parse_yaml(text, ""));
}

/// The number of the file's instant: its own, else its folder's.
std::optional<Numbered> instant_of(const fs::path& file) {
  if (auto own = numbered(file.stem().string())) return own;
  auto of_folder = numbered(file.parent_path().filename().string());
  if (of_folder) of_folder->name = file.stem().string();
  return of_folder;
}

bool is_pose_file(const fs::directory_entry& entry) {
  std::error_code is_gone;
  return entry.is_regular_file(is_gone) && entry.file_size(is_gone) <= longest_pose &&
         !poses_of_instant(read_file(entry.path())).empty();
}

}  // namespace

NamedPosesOfInstant poses_of_instant(const std::string& text) {
  if (text.size() > longest_pose) return {};
  try {
    if (const auto pose = single_pose(text)) return {{"", *pose}};
    const bool is_map = looks_like_yaml(text) || first_line(text).starts_with("{");
    return is_map && !text.starts_with("%YAML") ? poses_of_map(parse_yaml(text, "")) : NamedPosesOfInstant{};
  } catch (const InputError&) {
    return {};
  }
}

std::vector<fs::path> pose_files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    std::error_code is_gone;
    if (!numbered(entry.path().stem().string())) continue;
    if (is_pose_file(entry)) files.push_back(entry.path());
    if (!entry.is_directory(is_gone)) continue;
    for (const auto& inside : fs::directory_iterator(entry.path(), is_gone))
      if (!numbered(inside.path().stem().string()) && is_pose_file(inside)) files.push_back(inside.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<ReadPoses> read_pose_files(const std::vector<fs::path>& files, const std::string& what,
                                       std::vector<Message>& notes) {
  Groups groups;
  for (const fs::path& file : files) {
    const auto at = instant_of(file);
    const NamedPosesOfInstant poses = poses_of_instant(read_file(file));
    if (!at || poses.empty())
      throw InputError(
          message("{}: holds no single pose, or has no number in its name; expected a 4x4 matrix.", shown_path(file)));
    for (const auto& [name, pose] : poses)
      if (!groups[name.empty() ? at->name : name].emplace(at->number, pose).second)
        throw InputError(message("{}: another file of poses has the number {} too; expected one for each instant.",
                                 shown_path(file), at->number));
  }
  return series_of(groups, what, notes);
}

namespace {

using Rows = std::vector<std::vector<double>>;

/// "pose1: [...]", by number; nothing where two names have numbers, as of two things.
Rows numbered_rows(const std::map<std::string, StorageEntry>& entries) {
  std::map<std::int64_t, std::vector<double>> rows;
  std::string only;
  for (const auto& [name, entry] : entries) {
    const auto at = numbered(name);
    const std::size_t count = entry.numbers.size();
    if (!at || !entry.fault.empty() || (count != 6 && count != 7)) continue;
    if (!rows.empty() && (at->name != only || count != rows.begin()->second.size())) return {};
    only = at->name;
    rows[at->number] = entry.numbers;
  }
  Rows list;
  for (auto& [number, row] : rows) list.push_back(std::move(row));
  return list;
}

/// "Rotation_Vec" and "Translation_Vec", three numbers of each pose.
Rows rows_of_two_lists(const std::map<std::string, StorageEntry>& entries) {
  const auto find_list = [&](std::initializer_list<const char*> words) -> const StorageEntry* {
    const StorageEntry* only = nullptr;
    for (const auto& [name, entry] : entries) {
      const std::string lower = lower_case(name);
      const bool is_named = std::any_of(words.begin(), words.end(),
                                        [&](const char* word) { return lower.find(word) != std::string::npos; });
      if (!is_named || !entry.fault.empty() || entry.cols != 3 || entry.rows < 2) continue;
      if (only) return nullptr;
      only = &entry;
    }
    return only;
  };
  const StorageEntry *turns = find_list({"rotation", "rvec"}), *places = find_list({"translation", "tvec"});
  if (!turns || !places || turns->rows != places->rows) return {};
  Rows list;
  for (std::ptrdiff_t i = 0; i < turns->rows; ++i) {
    auto& row = list.emplace_back(places->numbers.begin() + 3 * i, places->numbers.begin() + 3 * i + 3);
    row.insert(row.end(), turns->numbers.begin() + 3 * i, turns->numbers.begin() + 3 * i + 3);
  }
  return list;
}

}  // namespace

std::optional<Table> pose_rows_of_storage(const std::string& text, const std::string& file) {
  const auto entries = parse_opencv_storage(text, file);
  // Beside a camera's matrix such lists are where its calibration saw the board.
  if (std::any_of(entries.begin(), entries.end(), [](const auto& e) { return is_matrix(e.second, 3, 3); }))
    return std::nullopt;
  Table table;
  table.file = file;
  table.rows = numbered_rows(entries);
  if (table.rows.empty()) table.rows = rows_of_two_lists(entries);
  if (table.rows.size() < 2) return std::nullopt;
  table.columns.resize(table.rows.front().size());
  for (std::size_t i = 0; i < table.rows.size(); ++i) table.lines.push_back(static_cast<int>(i) + 1);
  return table;
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
