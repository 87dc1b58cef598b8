// SPDX-License-Identifier: Apache-2.0
#include "readers/pose_list.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "base/bounds.h"
#include "base/error.h"
#include "base/text.h"
#include "readers/yaml_text.h"

namespace handsight {
namespace {

[[noreturn]] void refuse_pose(const std::string& file, std::size_t number, const char* why) {
  throw InputError(message("{}: pose {} {}; expected x y z in m and a unit quaternion x y z w.", file, number, why));
}

Rigid find_instant_pose(const std::vector<double>& xyz, const std::vector<double>& q, const std::string& file,
                        std::size_t number) {
  for (const double x : xyz)
    if (!bounds::length.hold(x)) refuse_pose(file, number, "lies outside of any room");
  const Eigen::Quaterniond rotation(q[3], q[0], q[1], q[2]);
  if (!(std::abs(rotation.norm() - 1) < 0.05)) refuse_pose(file, number, "has no unit quaternion");
  return {rotation.normalized().toRotationMatrix(), Vector3(xyz.data())};
}

std::optional<std::vector<double>> list_numbers(const YAML::Node& node, std::initializer_list<const char*> keys) {
  if (!node) return std::nullopt;
  if (node.IsSequence()) return yaml_numbers(node);
  if (!node.IsMap()) return std::nullopt;
  std::vector<double> all;
  for (const char* key : keys) {
    const auto n = yaml_number(node, key);
    if (!n) return std::nullopt;
    all.push_back(*n);
  }
  return all;
}

YAML::Node first_of(const YAML::Node& map, std::initializer_list<const char*> keys) {
  for (const char* key : keys)
    if (map.IsMap() && map[key]) return map[key];
  return YAML::Node(YAML::NodeType::Undefined);
}

/// Lists of poses, by the name that the file has for them.
struct NamedLists {
  std::vector<std::string> names;
  std::vector<std::vector<Rigid>> poses;
};

void add_pose(NamedLists& lists, const std::string& name, const Rigid& pose) {
  const auto at = std::find(lists.names.begin(), lists.names.end(), name);
  const auto place = static_cast<std::size_t>(at - lists.names.begin());
  if (at == lists.names.end()) {
    lists.names.push_back(name);
    lists.poses.emplace_back();
  }
  lists.poses[place].push_back(pose);
}

/// A list of two poses, or a map that names some.
bool add_pair(const YAML::Node& node, const std::string& file, std::size_t number, NamedLists& lists) {
  bool has_any = false;
  if (node.IsSequence() && node.size() == 2) {
    for (std::size_t i = 0; i < 2; ++i)
      if (const auto pose = find_pose(node[i], file, number)) {
        add_pose(lists, i == 0 ? "flange" : "target", *pose);
        has_any = true;
      }
  } else if (node.IsMap()) {
    for (const auto& entry : node)
      if (const auto pose = find_pose(entry.second, file, number)) {
        add_pose(lists, entry.first.Scalar(), *pose);
        has_any = true;
      }
  }
  return has_any;
}

NamedLists lists_in(const YAML::Node& list, const std::string& file) {
  NamedLists lists;
  std::size_t number = 0;
  for (const YAML::Node& node : list) {
    if (const auto pose = find_pose(node, file, number))
      add_pose(lists, "", *pose);
    else if (!add_pair(node, file, number, lists))
      refuse_pose(file, number, "is not whole");
    ++number;
  }
  return lists;
}

YAML::Node list_of(const YAML::Node& yaml) {
  return yaml.IsMap() ? first_of(yaml, {"poses", "samples", "transforms"}) : yaml;
}

bool begins_with_a_pose(const YAML::Node& list) {
  if (!list || !list.IsSequence() || list.size() == 0) return false;
  try {
    NamedLists lists;
    return find_pose(list[0], "", 0).has_value() || add_pair(list[0], "", 0, lists);
  } catch (const InputError&) {
    return true;
  }
}

/// "R_gripper2base" and "t_gripper2base": the list of places to a list of rotations; undefined where there is none.
YAML::Node places_beside(const YAML::Node& yaml, const std::string& rotations) {
  const bool is_named_so = rotations.size() > 1 && (rotations[0] == 'R' || rotations[0] == 'r');
  return is_named_so ? first_of(yaml, {("t" + rotations.substr(1)).c_str(), ("T" + rotations.substr(1)).c_str()})
                     : YAML::Node(YAML::NodeType::Undefined);
}

/// The pose of a rotation and a place of two lists.
std::optional<Rigid> pose_of_parts(const YAML::Node& rotation, const YAML::Node& place) {
  const auto r = yaml_numbers(rotation), t = yaml_numbers(place);
  return r && t && r->size() == 9 && t->size() == 3 ? rigid_of_parts(*r, *t) : std::nullopt;
}

/// Does the map hold this list of rotations with the list of their places?
bool are_parts(const YAML::Node& yaml, const std::string& name, const YAML::Node& rotations) {
  const YAML::Node places = places_beside(yaml, name);
  return places && places.IsSequence() && rotations.IsSequence() && rotations.size() > 2 &&
         rotations.size() == places.size() && pose_of_parts(rotations[0], places[0]);
}

void add_parts(const YAML::Node& yaml, const std::string& name, const YAML::Node& rotations, const std::string& file,
               NamedLists& lists) {
  const YAML::Node places = places_beside(yaml, name);
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    const auto pose = pose_of_parts(rotations[i], places[i]);
    if (!pose) refuse_pose(file, i, "is not whole");
    add_pose(lists, name.substr(name[1] == '_' ? 2 : 1), *pose);
  }
}

/// Poses of its entries; a list of pairs names them as a list of its own does.
NamedLists lists_of_map(const YAML::Node& yaml, const std::string& file) {
  NamedLists lists;
  for (const auto& entry : yaml) {
    const std::string name = entry.first.Scalar();
    if (are_parts(yaml, name, entry.second)) add_parts(yaml, name, entry.second, file, lists);
    if (!begins_with_a_pose(entry.second) || entry.second.size() < 3) continue;
    std::size_t number = 0;
    for (const YAML::Node& node : entry.second) {
      if (const auto pose = find_pose(node, file, number))
        add_pose(lists, name, *pose);
      else if (!add_pair(node, file, number, lists))
        refuse_pose(file, number, "is not whole");
      ++number;
    }
  }
  return lists;
}

/// A map whose values are lists of poses, or of their rotations and places.
bool is_map_of_lists(const YAML::Node& yaml) {
  return yaml.IsMap() && std::any_of(yaml.begin(), yaml.end(), [&](const auto& entry) {
           return entry.second.IsSequence() && entry.second.size() > 2 &&
                  (begins_with_a_pose(entry.second) || are_parts(yaml, entry.first.Scalar(), entry.second));
         });
}

std::vector<double> times_in(const YAML::Node& list) {
  std::vector<double> times;
  for (const YAML::Node& node : list)
    if (const auto time = node.IsMap() ? yaml_number(node, "time") : std::nullopt) times.push_back(*time);
  return times;
}

ReadPoses named(const std::string& name, std::vector<Rigid> poses) {
  ReadPoses read;
  read.role = name;
  read.series.poses = std::move(poses);
  return read;
}

}  // namespace

std::optional<Rigid> rigid_of_parts(const std::vector<double>& rotation, const std::vector<double>& place) {
  const Matrix3 m = Matrix3(rotation.data()).transpose();  // row by row
  if (!((m * m.transpose() - Matrix3::Identity()).norm() < 0.02) || !(m.determinant() > 0)) return std::nullopt;
  return Rigid{nearest_rotation(m), Vector3(place.data())};
}

std::optional<Rigid> rigid_of_numbers(const std::vector<double>& n) {
  if (n.size() != 16 && n.size() != 12) return std::nullopt;
  const auto ends_so = [&](std::size_t a, std::size_t b, std::size_t c) {
    return std::abs(n[a]) + std::abs(n[b]) + std::abs(n[c]) + std::abs(n[15] - 1) < 1e-6;
  };
  if (n.size() == 12 || ends_so(12, 13, 14))
    return rigid_of_parts({n[0], n[1], n[2], n[4], n[5], n[6], n[8], n[9], n[10]}, {n[3], n[7], n[11]});
  if (ends_so(3, 7, 11))  // column by column, as libfranka has them
    return rigid_of_parts({n[0], n[4], n[8], n[1], n[5], n[9], n[2], n[6], n[10]}, {n[12], n[13], n[14]});
  return std::nullopt;
}

std::optional<Rigid> find_pose(const YAML::Node& node, const std::string& file, std::size_t number) {
  if (!node) return std::nullopt;
  if (node.IsSequence()) {
    if (node.size() != 4 && node.size() != 16 && node.size() != 3 && node.size() != 12) return std::nullopt;
    const auto numbers = yaml_numbers(node);
    return numbers ? rigid_of_numbers(*numbers) : std::nullopt;
  }
  if (!node.IsMap()) return std::nullopt;
  if (node["pose"] && node["pose"].IsMap()) return find_pose(node["pose"], file, number);
  if (node["transform"] && node["transform"].IsMap()) return find_pose(node["transform"], file, number);
  const auto xyz = list_numbers(first_of(node, {"translation", "position", "xyz", "t"}), {"x", "y", "z"});
  const auto q = list_numbers(
      first_of(node, {"rotation", "orientation", "quaternion", "quaternion_xyzw", "q", "rotation_matrix", "R"}),
      {"x", "y", "z", "w"});
  if (!xyz || !q || xyz->size() != 3) return std::nullopt;
  if (q->size() == 9) return rigid_of_parts(*q, *xyz);
  if (q->size() != 4) return std::nullopt;
  return find_instant_pose(*xyz, *q, file, number);
}

Rigid required_pose(const YAML::Node& node, const std::string& file, std::size_t number) {
  const auto pose = find_pose(node, file, number);
  if (!pose) refuse_pose(file, number, "is not whole");
  return *pose;
}

void bring_to_metres(PoseSeries& series, const std::string& file, std::vector<Message>& notes) {
  double largest = 0;
  for (const Rigid& pose : series.poses) largest = std::max(largest, pose.translation.cwiseAbs().maxCoeff());
  if (largest <= longest_m) return;
  for (Rigid& pose : series.poses) pose.translation *= 1e-3;
  notes.push_back(message("{}: lengths of {:.0f} are taken for millimetres; a session holds metres.", file, largest));
}

bool is_pose_list(const YAML::Node& yaml) { return begins_with_a_pose(list_of(yaml)) || is_map_of_lists(yaml); }

std::vector<ReadPoses> read_pose_list(const YAML::Node& yaml, const std::string& file, std::vector<Message>& notes) {
  const YAML::Node list = list_of(yaml);
  const bool is_list = begins_with_a_pose(list);
  NamedLists lists = is_list ? lists_in(list, file) : lists_of_map(yaml, file);
  if (lists.names.size() > 2)
    throw InputError(message("{}: holds poses of {} things ({}); expected those of the flange and of the target.", file,
                             lists.names.size(), shortened(fmt::format("{}", fmt::join(lists.names, ", ")))));
  if (lists.names.size() == 2 && lists.poses[0].size() != lists.poses[1].size())
    throw InputError(message("{}: has {} poses {} and {} poses {}; expected one of each an instant.", file,
                             lists.poses[0].size(), in_quotes(lists.names[0]), lists.poses[1].size(),
                             in_quotes(lists.names[1])));
  std::vector<ReadPoses> all;
  for (std::size_t i = 0; i < lists.names.size(); ++i) {
    ReadPoses& read = all.emplace_back(named(lists.names[i], std::move(lists.poses[i])));
    if (is_list) read.series.times = times_in(list);
    if (read.series.times.size() != read.series.poses.size()) read.series.times.clear();
    bring_to_metres(read.series, file, notes);
  }
  return all;
}

}  // namespace handsight
