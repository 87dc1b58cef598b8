// SPDX-License-Identifier: Apache-2.0
#include "readers/pose_files.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/bounds.h"
#include "base/error.h"
#include "base/text.h"

namespace handsight {
namespace {

[[noreturn]] void refuse_pose(const std::string& file, std::size_t number, const char* why) {
  throw InputError(
      fmt::format("{}: pose {} {}; expected x y z in m and a unit quaternion x y z w.", file, number, why));
}

Rigid pose_of(const std::vector<double>& xyz, const std::vector<double>& q, const std::string& file,
              std::size_t number) {
  for (const double x : xyz)
    if (!bounds::length.hold(x)) refuse_pose(file, number, "lies outside of any room");
  const Eigen::Quaterniond rotation(q[3], q[0], q[1], q[2]);
  if (!(std::abs(rotation.norm() - 1) < 0.05)) refuse_pose(file, number, "has no unit quaternion");
  return {rotation.normalized().toRotationMatrix(), Vector3(xyz.data())};
}

std::optional<std::vector<double>> numbers_of(const YAML::Node& node, std::initializer_list<const char*> keys) {
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

std::optional<Rigid> find_pose(const YAML::Node& node, const std::string& file, std::size_t number) {
  if (!node || !node.IsMap()) return std::nullopt;
  if (node["pose"] && node["pose"].IsMap()) return find_pose(node["pose"], file, number);
  if (node["transform"] && node["transform"].IsMap()) return find_pose(node["transform"], file, number);
  const auto xyz = numbers_of(first_of(node, {"translation", "position", "xyz", "t"}), {"x", "y", "z"});
  const auto q = numbers_of(first_of(node, {"rotation", "orientation", "quaternion", "quaternion_xyzw", "q"}),
                            {"x", "y", "z", "w"});
  if (!xyz || !q || xyz->size() != 3 || q->size() != 4) return std::nullopt;
  return pose_of(*xyz, *q, file, number);
}

Rigid required_pose(const YAML::Node& node, const std::string& file, std::size_t number) {
  const auto pose = find_pose(node, file, number);
  if (!pose) refuse_pose(file, number, "is not whole");
  return *pose;
}

/// Millimetres where lengths can be nothing else.
template <class Take>
void take_for_metres(double largest, const std::string& file, const Take& scale, std::vector<std::string>& notes) {
  if (largest <= longest_m) return;
  scale(1e-3);
  notes.push_back(
      fmt::format("{}: lengths of {:.0f} are taken for millimetres; a session holds metres.", file, largest));
}

struct PoseColumns {
  std::vector<std::size_t> xyz, rotation;  // a quaternion x y z w, or roll pitch yaw
  bool degrees = false;
};

std::optional<PoseColumns> pose_columns(const Table& t) {
  PoseColumns c;
  const auto all = [&](std::initializer_list<std::initializer_list<const char*>> names) {
    std::vector<std::size_t> columns;
    for (const auto& alternatives : names)
      if (const auto found = find_column(t, alternatives)) columns.push_back(*found);
    return columns.size() == names.size() ? columns : std::vector<std::size_t>();
  };
  if (t.has_header) {
    c.xyz = all({{"x", "tx", "px", "position.x", "translation.x", "position_x", "translation_x", "pos_x"},
                 {"y", "ty", "py", "position.y", "translation.y", "position_y", "translation_y", "pos_y"},
                 {"z", "tz", "pz", "position.z", "translation.z", "position_z", "translation_z", "pos_z"}});
    c.rotation = all({{"qx", "orientation.x", "rotation.x", "orientation_x", "q_x", "rotation_x"},
                      {"qy", "orientation.y", "rotation.y", "orientation_y", "q_y", "rotation_y"},
                      {"qz", "orientation.z", "rotation.z", "orientation_z", "q_z", "rotation_z"},
                      {"qw", "orientation.w", "rotation.w", "orientation_w", "q_w", "rotation_w"}});
    if (c.rotation.empty()) c.rotation = all({{"roll", "rx"}, {"pitch", "ry"}, {"yaw", "rz"}});
    if (c.xyz.empty() || c.rotation.empty()) return std::nullopt;
    c.degrees = t.columns[c.rotation[0]].unit == "deg";
    return c;
  }
  if (t.width() != 7 && t.width() != 8) return std::nullopt;
  const std::size_t first = t.width() - 7;
  for (const auto& row : t.rows) {
    double squares = 0;
    for (std::size_t i = 3; i < 7; ++i) squares += row[first + i] * row[first + i];
    if (!(std::abs(squares - 1) < 0.01)) return std::nullopt;
  }
  return PoseColumns{{first, first + 1, first + 2}, {first + 3, first + 4, first + 5, first + 6}};
}

}  // namespace

bool is_hand_eye_samples(const YAML::Node& yaml) {
  const YAML::Node samples = yaml.IsMap() ? yaml["samples"] : YAML::Node();
  return samples && samples.IsSequence() && samples.size() > 0 && samples[0].IsMap() && samples[0]["robot"] &&
         (samples[0]["tracking"] || samples[0]["optical"]);
}

HandEyeSamples read_hand_eye_samples(const YAML::Node& yaml, const std::string& file, std::vector<std::string>& notes) {
  HandEyeSamples s;
  const std::string kind = yaml_word(yaml["parameters"], "calibration_type"),
                    on_hand = yaml_word(yaml["parameters"], "eye_on_hand");
  s.kind_is_known = !kind.empty() || !on_hand.empty();
  s.eye_in_hand = kind.empty() ? on_hand != "false" : kind.find("in_hand") != std::string::npos;
  std::size_t number = 0;
  for (const YAML::Node& sample : yaml["samples"]) {
    const Rigid robot = required_pose(sample["robot"], file, number);
    // With the camera on its stand easy_handeye looks the robot's pose up the other way round.
    s.base_from_effector.push_back(s.eye_in_hand ? robot : inverse(robot));
    s.camera_from_target.push_back(
        required_pose(sample["tracking"] ? sample["tracking"] : sample["optical"], file, number));
    ++number;
  }
  if (!s.kind_is_known)
    notes.push_back(file +
                    ": does not say where the camera is; it is taken to be on the hand (--eye-on-base: on a "
                    "stand).");
  return s;
}

bool is_pose_list(const YAML::Node& yaml) {
  const YAML::Node list = yaml.IsMap() ? first_of(yaml, {"poses", "samples", "transforms"}) : yaml;
  if (!list || !list.IsSequence() || list.size() == 0) return false;
  try {
    return find_pose(list[0], "", 0).has_value();
  } catch (const InputError&) {
    return true;
  }
}

PoseSeries read_pose_list(const YAML::Node& yaml, const std::string& file) {
  PoseSeries series;
  const YAML::Node list = yaml.IsMap() ? first_of(yaml, {"poses", "samples", "transforms"}) : yaml;
  for (const YAML::Node& node : list) {
    series.poses.push_back(required_pose(node, file, series.poses.size()));
    if (const auto time = yaml_number(node, "time")) series.times.push_back(*time);
  }
  if (series.times.size() != series.poses.size()) series.times.clear();
  return series;
}

bool is_pose_table(const Table& table) { return pose_columns(table).has_value(); }

PoseSeries read_pose_table(Table table, std::vector<std::string>& notes) {
  const auto columns = pose_columns(table);
  check(columns.has_value(), "{} is no table of poses", table.file);
  PoseSeries series;
  if (!table.has_header && table.width() == 8) table.columns[0].name = "time";
  series.times = times_of(table, notes);
  sort_by_time(table, series.times, notes);
  std::vector<std::size_t> used = columns->xyz;
  used.insert(used.end(), columns->rotation.begin(), columns->rotation.end());
  require_full(table, used);
  if (!table.has_header)
    notes.push_back(fmt::format("{}: has no header; its columns are taken for {}x y z qx qy qz qw.", table.file,
                                table.width() == 8 ? "time " : ""));
  double largest = 0;
  for (const auto& row : table.rows) {
    std::vector<double> xyz, r;
    for (const std::size_t c : columns->xyz) xyz.push_back(row[c] * (table.columns[c].unit == "mm" ? 1e-3 : 1));
    for (const std::size_t c : columns->rotation) r.push_back(row[c]);
    for (const double x : xyz) largest = std::max(largest, std::abs(x));
    if (r.size() == 4) {
      series.poses.push_back(pose_of(xyz, r, table.file, series.poses.size()));
    } else {
      const double unit = columns->degrees ? std::numbers::pi / 180 : 1;
      series.poses.push_back({rotation_from_rpy(Vector3(r.data()) * unit), Vector3(xyz.data())});
    }
  }
  take_for_metres(
      largest, table.file,
      [&](double factor) {
        for (Rigid& pose : series.poses) pose.translation *= factor;
      },
      notes);
  return series;
}

}  // namespace handsight
