// SPDX-License-Identifier: Apache-2.0
#include "readers/pose_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>

#include "base/letters.h"
#include "base/text.h"

namespace handsight {
namespace {

using Names = std::vector<std::string>;

/// "x1", "phiy2": a part of a pose and its number, as programs of identification call them.
bool is_numbered_part(const std::string& letters) {
  for (const char* axis : {"x", "y", "z"})
    for (const char* before : {"", "t", "p", "r", "phi", "rv"})
      if (letters == before + std::string(axis)) return true;
  for (const char* part : {"qx", "qy", "qz", "qw", "roll", "pitch", "yaw"})
    if (letters == part) return true;
  return false;
}

/// "x1" in two words: "1" and "x".
void split_number(Names& words) {
  const std::string last = words.empty() ? "" : words.back();
  const std::size_t digit = last.find_first_of("0123456789");
  if (digit == std::string::npos || last.find_first_not_of("0123456789", digit) != std::string::npos) return;
  if (!is_numbered_part(last.substr(0, digit))) return;
  words.back() = last.substr(digit);
  words.push_back(last.substr(0, digit));
}

Names list_words(const std::string& name) {
  Names words{""};
  for (const char c : lower_case(name)) {
    if (std::string_view("_.-:/ ").find(c) != std::string_view::npos)
      words.emplace_back();
    else
      words.back() += c;
  }
  std::erase(words, "");
  split_number(words);
  return words;
}

std::string joined(Names words, std::size_t begin, std::size_t end) {
  return fmt::format("{}", fmt::join(words.begin() + static_cast<std::ptrdiff_t>(begin),
                                     words.begin() + static_cast<std::ptrdiff_t>(end), "_"));
}

bool is_one_of(const std::string& word, std::initializer_list<const char*> list) {
  return std::any_of(list.begin(), list.end(), [&](const char* one) { return word == one; });
}

/// A column's part of a pose, and of what.
struct Component {
  std::string role, name;
};

/// "x" of a place, "rx" of three angles, "qx" of a quaternion; others as they are. Empty: no part of a pose.
std::string component_of(const std::string& before, const std::string& last) {
  const bool is_axis = last == "x" || last == "y" || last == "z", is_w = last == "w";
  if (is_one_of(before, {"position", "translation", "pos", "trans", "tvec", "t", "p", "xyz"}) && is_axis) return last;
  if (is_one_of(before, {"orientation", "rotation", "quaternion", "quat", "q", "rot", "ori", "o", "r"}) &&
      (is_axis || is_w))
    return "q" + last;
  if (is_one_of(before, {"rvec", "rotvec", "rv", "axisangle"}) && is_axis) return "rv" + last;
  if (is_axis) return last;
  if (last.size() == 2 && is_one_of(last, {"tx", "ty", "tz", "px", "py", "pz"})) return last.substr(1);
  if (is_one_of(last, {"qx",  "qy", "qz", "qw", "q0", "q1", "q2", "q3", "q4", "rx", "ry", "rz",    "roll", "pitch",
                       "yaw", "a",  "b",  "c",  "w",  "p",  "r",  "o",  "t",  "u",  "v",  "alpha", "beta", "gamma"}))
    return last;
  if (is_one_of(last, {"rvx", "rvy", "rvz", "phix", "phiy", "phiz"})) return last;
  if (last == "wx" || last == "ax" || last == "ox") return "rvx";
  if (last == "wy" || last == "ay" || last == "oy") return "rvy";
  if (last == "wz" || last == "az" || last == "oz") return "rvz";
  return "";
}

bool is_between(const std::string& word) {
  return is_one_of(
      word, {"position",   "translation", "pos", "trans", "tvec", "t", "p",    "xyz",    "orientation", "rotation",
             "quaternion", "quat",        "q",   "rot",   "ori",  "r", "rvec", "rotvec", "rv",          "axisangle"});
}

/// Names whose first words say what the pose is of: "tag_qx", "tag.orientation.x", "pose.pose.position.x".
std::optional<Component> component_at_end(const Names& words) {
  const bool has_between = words.size() > 1 && is_between(words[words.size() - 2]);
  const std::string name = component_of(has_between ? words[words.size() - 2] : "", words.back());
  if (name.empty()) return std::nullopt;
  Names of(words.begin(), words.end() - (has_between ? 2 : 1));
  std::erase(of, "pose");
  return Component{joined(of, 0, of.size()), name};
}

/// "x_robot", "qx_robot".
std::optional<Component> component_at_begin(const Names& words) {
  if (words.size() < 2) return std::nullopt;
  const std::string name = component_of("", words.front());
  if (name.empty()) return std::nullopt;
  return Component{joined(words, 1, words.size()), name};
}

/// Columns by what their pose is of, in the table's order; each component once.
struct Group {
  std::string role;
  std::map<std::string, std::size_t> columns;
  bool is_doubtful = false;  // a component is there twice: which belongs to which is not known
};

std::vector<Group> groups_of(const Table& t, std::size_t begin, std::size_t end, bool at_end) {
  std::vector<Group> groups;
  for (std::size_t c = begin; c < end; ++c) {
    const Names words = list_words(t.columns[c].name);
    if (words.empty()) continue;
    const auto component = at_end ? component_at_end(words) : component_at_begin(words);
    if (!component) continue;
    auto group = std::find_if(groups.begin(), groups.end(), [&](const Group& g) { return g.role == component->role; });
    if (group == groups.end()) group = groups.insert(groups.end(), Group{component->role, {}});
    group->is_doubtful |= !group->columns.emplace(component->name, c).second;
  }
  return groups;
}

struct Way {
  Names names;
  std::vector<AngleKind> kinds;
  bool first_is_usual, usually_degrees;
};

const std::vector<Way>& ways() {
  using K = AngleKind;
  static const std::vector<Way> all{
      {{"qx", "qy", "qz", "qw"}, {K::quaternion_xyzw}, true, false},
      {{"q0", "q1", "q2", "q3"}, {K::quaternion_wxyz, K::quaternion_xyzw}, true, false},
      {{"q1", "q2", "q3", "q4"}, {K::quaternion_wxyz, K::quaternion_xyzw}, true, false},
      {{"rvx", "rvy", "rvz"}, {K::rotation_vector}, true, false},
      {{"roll", "pitch", "yaw"}, {K::rpy}, true, false},
      {{"rx", "ry", "rz"}, {K::rotation_vector, K::rpy, K::moving_xyz}, false, false},
      {{"phix", "phiy", "phiz"}, {K::rpy, K::rotation_vector, K::moving_xyz}, false, false},
      {{"w", "p", "r"}, {K::rpy}, true, true},
      {{"o", "a", "t"}, {K::zyz}, true, true},
      {{"a", "b", "c"}, {K::zyx, K::rpy, K::zyz, K::moving_xyz}, true, true},
      {{"u", "v", "w"}, {K::zyx, K::rpy, K::moving_xyz}, true, true},
      {{"qx", "qy", "qz"}, {K::rotation_vector, K::rpy, K::moving_xyz}, false, false},  // "rotation.x"
      {{"alpha", "beta", "gamma"}, {K::rpy, K::zyx, K::moving_xyz, K::zyz, K::rotation_vector}, false, false},
  };
  return all;
}

std::vector<std::size_t> list_columns(const Group& group, const Names& names) {
  std::vector<std::size_t> columns;
  for (const std::string& name : names)
    if (const auto found = group.columns.find(name); found != group.columns.end()) columns.push_back(found->second);
  return columns.size() == names.size() ? columns : std::vector<std::size_t>();
}

std::string make_text(const Table& t, const std::vector<std::size_t>& columns) {
  std::string text;
  for (const std::size_t c : columns) text += (text.empty() ? "" : " ") + shortened(t.columns[c].name, 30);
  return text;
}

std::optional<PoseColumns> named_pose(const Table& t, const Group& group) {
  PoseColumns p;
  p.role = group.role;
  p.xyz = list_columns(group, {"x", "y", "z"});
  if (p.xyz.empty() || group.is_doubtful) return std::nullopt;
  for (const Way& way : ways()) {
    p.turn = list_columns(group, way.names);
    if (p.turn.empty()) continue;
    p.kinds = way.kinds;
    p.first_is_usual = way.first_is_usual;
    p.usually_degrees = way.usually_degrees;
    p.text = verbatim(make_text(t, p.turn));
    return p;
  }
  return std::nullopt;
}

std::vector<PoseColumns> named_poses(const Table& t, std::size_t begin, std::size_t end) {
  for (const bool at_end : {true, false}) {
    std::vector<PoseColumns> poses;
    for (const Group& group : groups_of(t, begin, end, at_end))
      if (auto pose = named_pose(t, group)) poses.push_back(std::move(*pose));
    if (!poses.empty()) return poses;
  }
  return {};
}

/// The first column whose name stands before it already; the width where there is none.
std::size_t first_repeated(const Table& t) {
  for (std::size_t c = 1; c < t.width(); ++c)
    for (std::size_t before = 0; before < c; ++before)
      if (const Names name = list_words(t.columns[c].name); !name.empty() && list_words(t.columns[before].name) == name)
        return c;
  return t.width();
}

/// A header that has the same names twice, first of one thing and then of the other.
std::vector<PoseColumns> named_twice(const Table& t) {
  const std::size_t middle = first_repeated(t);
  auto first = named_poses(t, 0, middle), second = named_poses(t, middle, t.width());
  if (first.size() != 1 || second.size() != 1) return {};
  if (first[0].role == second[0].role) first[0].role = "flange", second[0].role = "target";
  return {first[0], second[0]};
}

// ---- by their numbers

using Row = std::vector<double>;

bool is_missing(const Row& row, std::size_t first, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i)
    if (!std::isfinite(row[first + i])) return true;
  return false;
}

bool all_rows(const Table& t, std::size_t first, std::size_t count,
              const std::function<bool(const double* numbers)>& holds) {
  bool is_any = false;
  for (const Row& row : t.rows) {
    if (is_missing(row, first, count)) continue;
    is_any = true;
    if (!holds(row.data() + first)) return false;
  }
  return is_any;
}

bool is_rotation(const Matrix3& m) {
  return (m * m.transpose() - Matrix3::Identity()).norm() < 0.02 && m.determinant() > 0;
}

constexpr std::array<std::size_t, 9> by_rows{0, 1, 2, 4, 5, 6, 8, 9, 10}, by_columns{0, 4, 8, 1, 5, 9, 2, 6, 10};

Matrix3 rotation_at(const double* n, const std::array<std::size_t, 9>& places) {
  Matrix3 m;
  for (std::size_t i = 0; i < 9; ++i)
    m(static_cast<Eigen::Index>(i / 3), static_cast<Eigen::Index>(i % 3)) = n[places[i]];
  return m;
}

bool ends_as_a_motion(double a, double b, double c, double d) {
  return std::abs(a) + std::abs(b) + std::abs(c) + std::abs(d - 1) < 1e-6;
}

PoseColumns matrix_from(std::size_t first, const std::array<std::size_t, 9>& turn,
                        const std::array<std::size_t, 3>& place) {
  PoseColumns p;
  for (const std::size_t i : turn) p.turn.push_back(first + i);
  for (const std::size_t i : place) p.xyz.push_back(first + i);
  p.kinds = {AngleKind::matrix};
  p.first_is_usual = true;
  p.text = "the matrices";
  return p;
}

/// A matrix of four rows, or of its first three, that begins in this column.
std::optional<PoseColumns> matrix_at(const Table& t, std::size_t first, std::size_t& width) {
  width = 16;
  if (first + 16 <= t.width()) {
    if (all_rows(t, first, 16, [](const double* n) {
          return ends_as_a_motion(n[12], n[13], n[14], n[15]) && is_rotation(rotation_at(n, by_rows));
        }))
      return matrix_from(first, by_rows, {3, 7, 11});
    if (all_rows(t, first, 16, [](const double* n) {
          return ends_as_a_motion(n[3], n[7], n[11], n[15]) && is_rotation(rotation_at(n, by_columns));
        }))
      return matrix_from(first, by_columns, {12, 13, 14});
  }
  width = 12;
  if (first + 12 <= t.width() &&
      all_rows(t, first, 12, [](const double* n) { return is_rotation(rotation_at(n, by_rows)); }))
    return matrix_from(first, by_rows, {3, 7, 11});
  return std::nullopt;
}

std::vector<PoseColumns> matrices_in(const Table& t) {
  std::vector<PoseColumns> poses;
  for (std::size_t c = 0; c + 12 <= t.width() && poses.size() < 2;) {
    std::size_t width = 0;
    if (auto pose = matrix_at(t, c, width)) {
      poses.push_back(std::move(*pose));
      c += width;
    } else {
      ++c;
    }
  }
  return poses;
}

std::vector<std::size_t> counted(std::size_t first, std::size_t count) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < count; ++i) places.push_back(first + i);
  return places;
}

bool has_quaternion(const Table& t, std::size_t first) {
  return first + 4 <= t.width() && all_rows(t, first, 4, [](const double* q) {
           return std::abs(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3] - 1) < 0.01;
         });
}

PoseColumns unnamed_quaternion(std::size_t first) {
  PoseColumns p;
  p.xyz = counted(first, 3);
  p.turn = counted(first + 3, 4);
  p.kinds = {AngleKind::quaternion_xyzw, AngleKind::quaternion_wxyz};
  p.first_is_usual = true;
  p.text = "the last four columns";
  return p;
}

PoseColumns unnamed_angles(std::size_t first) {
  PoseColumns p;
  p.xyz = counted(first, 3);
  p.turn = counted(first + 3, 3);
  p.kinds = {AngleKind::rotation_vector, AngleKind::rpy, AngleKind::zyx, AngleKind::moving_xyz, AngleKind::zyz};
  p.text = "the last three columns";
  return p;
}

/// Columns of numbers without a name, after those of images' names.
std::vector<PoseColumns> unnamed_poses(const Table& t, bool has_robot) {
  std::size_t words = 0;
  while (words < t.width() && !t.columns[words].words.empty()) ++words;
  const std::size_t width = t.width() - words;
  for (const std::size_t first : {std::size_t{0}, std::size_t{1}}) {  // a time or a number may stand before
    if ((width == first + 7) && has_quaternion(t, words + first + 3)) return {unnamed_quaternion(words + first)};
    if ((width == first + 14) && has_quaternion(t, words + first + 3) && has_quaternion(t, words + first + 10))
      return {unnamed_quaternion(words + first), unnamed_quaternion(words + first + 7)};
  }
  if (has_robot) return {};
  for (const std::size_t first : {std::size_t{0}, std::size_t{1}}) {
    if (width == first + 6) return {unnamed_angles(words + first)};
    if (width == first + 12) return {unnamed_angles(words + first), unnamed_angles(words + first + 6)};
  }
  return {};
}

void name_two(std::vector<PoseColumns>& poses) {
  if (poses.size() == 2 && poses[0].role.empty() && poses[1].role.empty())
    poses[0].role = "flange", poses[1].role = "target";
}

}  // namespace

std::vector<PoseColumns> pose_columns(const Table& t, bool has_robot) {
  std::vector<PoseColumns> poses;
  if (t.has_header) {
    if (first_repeated(t) < t.width()) poses = named_twice(t);
    if (poses.empty()) poses = named_poses(t, 0, t.width());
    if (poses.size() > 2) return {};
  }
  if (poses.empty()) poses = matrices_in(t);
  if (poses.empty() && !t.has_header) poses = unnamed_poses(t, has_robot);
  name_two(poses);
  return poses;
}

Table with_matrices_in_rows(const Table& t) {
  if (t.has_header || t.width() != 4 || t.rows.size() % 4 != 0) return t;
  Table flat = t;
  flat.columns.assign(16, {});
  flat.rows.clear();
  flat.lines.clear();
  for (std::size_t r = 0; r < t.rows.size(); r += 4) {
    std::vector<double>& row = flat.rows.emplace_back();
    for (std::size_t i = 0; i < 4; ++i) row.insert(row.end(), t.rows[r + i].begin(), t.rows[r + i].end());
    flat.lines.push_back(t.lines[r]);
  }
  return matrices_in(flat).empty() ? t : flat;
}

}  // namespace handsight
