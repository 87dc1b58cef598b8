// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cctype>

#include "base/error.h"
#include "base/text.h"
#include "convert/convert_pairing.h"
#include "convert/convert_ways.h"

namespace handsight {
namespace {

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// Is the file likely of the robot's flange, by its name?
bool is_of_flange(const std::string& file) {
  return says(file, {"flange", "robot", "ee", "tool", "hand", "gripper", "arm"});
}
bool is_of_target(const std::string& file) {
  return says(file, {"target", "marker", "tag", "board", "cam", "track", "mocap", "object"});
}

constexpr char sensor_note[] =
    "The target's pose counts whole, place and turn; how exactly the sensor tells them is estimated. Where it is known "
    "write it into <pose_sensor>: sigma (m) and sigma_angle (rad).";

}  // namespace

bool says(const std::string& name, std::initializer_list<const char*> words) {
  return std::any_of(words.begin(), words.end(),
                     [&](const char* w) { return lower(name).find(w) != std::string::npos; });
}

std::pair<PoseSeries, PoseSeries> flange_and_target(const std::vector<NamedPoses>& poses) {
  const bool first = is_of_flange(poses[0].file) && !is_of_flange(poses[1].file),
             second = is_of_flange(poses[1].file) && !is_of_flange(poses[0].file);
  if (first || (is_of_target(poses[1].file) && !is_of_target(poses[0].file))) return {poses[0].series, poses[1].series};
  if (second || (is_of_target(poses[0].file) && !is_of_target(poses[1].file)))
    return {poses[1].series, poses[0].series};
  throw InputError(
      fmt::format("{} and {} are both tables of poses: which is the robot's flange, which the target that "
                  "the sensor sees? Name the files so: flange.csv and target.csv.",
                  poses[0].file, poses[1].file));
}

void set_flange(SessionParts& parts, const PoseSeries& flange, bool eye_in_hand, std::vector<std::string>& notes) {
  parts.joints.names = joint_names(poses_robot());
  for (const Rigid& pose : flange.poses) parts.joints.positions.emplace_back(position_of(pose));
  parts.tcp = eye_in_hand ? "base" : "flange";
  parts.mount = eye_in_hand ? "flange" : "base";
  notes.emplace_back(
      "No robot is known, only where its flange is: what bends or is off in its joints cannot be told apart; name its "
      "URDF and a table of joint readings for that.");
}

Conversion from_flange(const PoseSeries& flange, const PoseSeries& target, bool eye_in_hand, const ConvertOptions& o,
                       Conversion c) {
  if (flange.poses.size() != target.poses.size())
    throw InputError(
        fmt::format("There are {} poses of the flange and {} of the target; expected one of each an instant, "
                    "in the same order.",
                    flange.poses.size(), target.poses.size()));
  SessionParts parts;
  set_flange(parts, flange, eye_in_hand, c.notes);
  parts.times = target.times;
  parts.target_poses = target.poses;
  c.notes.emplace_back(sensor_note);
  c.session = write_measured_session(parts, o);
  return c;
}

Conversion from_poses(const FieldUrdf& robot, const JointSeries& joints, const PoseSeries& target,
                      const ConvertOptions& o, Conversion c) {
  SessionParts parts;
  require_links(robot, o, parts, c.notes);
  const std::vector<double> speeds = target.times.empty() ? std::vector<double>() : speeds_of(target);
  const Paired p = pair_events(joints, target.times, target.poses.size(), speeds, o, c.notes);
  parts.joints = {joints.names, {}, p.positions};
  parts.times = chosen(target.times, p.events);
  parts.target_poses = chosen(target.poses, p.events);
  c.notes.emplace_back(sensor_note);
  c.session = write_measured_session(parts, o);
  return c;
}

void require_links(const FieldUrdf& robot, const ConvertOptions& o, SessionParts& parts,
                   std::vector<std::string>& notes) {
  if (o.tcp.empty())
    throw InputError(fmt::format("--tcp is missing: the link that is the hand. At the ends of this robot are: {}.",
                                 shortened(fmt::format("{}", fmt::join(end_links(robot.robot), " ")), 300)));
  parts.urdf_text = robot.text;
  parts.tcp = o.tcp;
  parts.mount = o.mount.empty() ? robot.robot.links.front().name : o.mount;
  if (o.mount.empty())
    notes.push_back(fmt::format("--mount is not given: the sensor is taken to stand beside the robot (link {}).",
                                in_quotes(parts.mount)));
}

Conversion from_points(const FieldUrdf& robot, const JointSeries& joints, const PointSeries& points,
                       const std::vector<double>& speeds, const ConvertOptions& o, Conversion c) {
  SessionParts parts;
  require_links(robot, o, parts, c.notes);
  const Paired p = pair_events(joints, points.times, points.points.size(), speeds, o, c.notes);
  parts.joints = {joints.names, {}, p.positions};
  parts.times = chosen(points.times, p.events);
  parts.points = chosen(points.points, p.events);
  std::size_t unseen = 0;
  for (const auto& row : parts.points)
    for (const auto& point : row) unseen += !point.has_value();
  if (unseen > 0) c.notes.push_back(fmt::format("{} points were not seen by the device; they are left out.", unseen));
  c.session = write_measured_session(parts, o);
  return c;
}

}  // namespace handsight
