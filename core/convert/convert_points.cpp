// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "base/error.h"
#include "base/letters.h"
#include "base/text.h"
#include "chain/chain.h"
#include "convert/choose_turns.h"
#include "convert/convert_inputs.h"
#include "convert/convert_pairing.h"
#include "convert/pair_poses.h"

namespace handsight {
namespace {

/// Is a file, or what a file calls poses, likely of the robot's flange, of the target? By its name.
bool says_flange(const std::string& name) {
  return says(name, {"flange", "robot", "ee", "tool", "hand", "gripper", "arm", "effector", "tcp", "fpe"});
}

bool says_target(const std::string& name) {
  return says(name, {"target", "marker", "tag", "board", "cam", "track", "mocap", "object", "obj", "rvec", "pnp"});
}

/// What their columns call them, or their file (or folder) where columns say nothing of it and each has its own.
std::string called(const NamedPoses& p, const NamedPoses& other) {
  if (p.role.empty() && !says_flange(p.file) && !says_target(p.file)) return p.file + " " + p.turns.columns.english();
  const bool says_it = says_flange(p.role) || says_target(p.role);
  return p.role.empty() || (!says_it && p.file != other.file) ? p.file : p.role;
}

Message sensor_note(const ConvertOptions& o) {
  if (o.sigma && o.sigma_angle) return "The target's pose counts whole, place and turn.";
  return "The target's pose counts whole, place and turn; how exactly the sensor tells them is estimated. Where it is "
         "known say it: --sigma (m), --sigma-angle (rad), or in <pose_sensor>.";
}

/// Where both tables have as many rows, and no times in both: the readings of the rows in which the target was seen.
JointSeries of_seen_rows(JointSeries joints, const PoseSeries& seen) {
  const bool is_by_row = joints.times.empty() || seen.times.empty();
  if (!is_by_row || seen.places.empty() || seen.row_count != joints.positions.size()) return joints;
  std::vector<Eigen::VectorXd> positions;
  for (const std::size_t row : seen.places) positions.push_back(joints.positions[row]);
  joints.positions = std::move(positions);
  joints.times.clear();
  return joints;
}

}  // namespace

bool says(const std::string& name, std::initializer_list<const char*> words) {
  return std::any_of(words.begin(), words.end(),
                     [&](const char* w) { return lower_case(name).find(w) != std::string::npos; });
}

std::pair<NamedPoses, NamedPoses> flange_and_target(const std::vector<NamedPoses>& poses) {
  const std::string a = called(poses[0], poses[1]), b = called(poses[1], poses[0]);
  const bool first = says_flange(a) && !says_flange(b), second = says_flange(b) && !says_flange(a);
  if (first || (!second && says_target(b) && !says_target(a))) return {poses[0], poses[1]};
  if (second || (says_target(a) && !says_target(b))) return {poses[1], poses[0]};
  const auto name = [](const NamedPoses& p) { return p.role.empty() ? p.file : p.role; };
  throw InputError(
      message("{} and {} are both tables of poses: which is the robot's flange, which the target that "
              "the sensor sees? Say with --target-frame which is the target's, or name the files so: flange.csv and "
              "target.csv.",
              name(poses[0]), name(poses[1])));
}

NamedPoses hand_of(const FieldUrdf& robot, const SessionParts& parts) {
  Session s;
  s.robot = robot.robot;
  s.tcp = parts.tcp;
  s.mount.link = parts.mount;
  s.joints = parts.joints.names;
  const Chain chain = make_chain(s);
  NamedPoses hand{"the robot", "", {}};
  for (const Eigen::VectorXd& position : parts.joints.positions) {
    const ChainEnds ends = chain_ends(chain, position);
    hand.series.poses.push_back(inverse(ends.root_from_mount) * ends.root_from_tcp);
  }
  return hand;
}

void set_flange(SessionParts& parts, const PoseSeries& flange, bool eye_in_hand, std::vector<Message>& notes) {
  parts.joints.names = joint_names(poses_robot());
  for (const Rigid& pose : flange.poses) parts.joints.positions.emplace_back(make_position(pose));
  parts.tcp = eye_in_hand ? "base" : "flange";
  parts.mount = eye_in_hand ? "flange" : "base";
  notes.emplace_back(
      "No robot is known, only where its flange is: what bends or is off in its joints cannot be told apart; name its "
      "URDF and a table of joint readings for that.");
}

Conversion from_flange(NamedPoses flange, NamedPoses target, bool eye_in_hand, const ConvertOptions& o, Conversion c) {
  pair_poses(flange, target, o, c.notes);
  choose_turns(flange, target, eye_in_hand, c.notes);
  SessionParts parts;
  set_flange(parts, flange.series, eye_in_hand, c.notes);
  parts.times = target.series.times.empty() ? flange.series.times : target.series.times;
  parts.target_poses = target.series.poses;
  c.notes.push_back(sensor_note(o));
  c.session = write_measured_session(parts, o);
  return c;
}

namespace {

/// The largest turn between the first of these poses and another, rad.
double largest_turn(const std::vector<Rigid>& poses) {
  double largest = 0;
  for (const Rigid& pose : poses)
    largest =
        std::max(largest, vector_from_rotation(Matrix3(poses.front().rotation.transpose() * pose.rotation)).norm());
  return largest;
}

/// Turns that never change while the hand turns: the device measures places alone, and writes numbers for the rest.
bool tells_no_turn(const NamedPoses& target, const std::vector<Rigid>& hand) {
  constexpr double exact = 1e-9, turned = 0.1;  // rad
  return target.series.poses.size() > 2 && largest_turn(target.series.poses) < exact && largest_turn(hand) > turned;
}

}  // namespace

Conversion from_poses(const FieldUrdf& robot, const JointSeries& joints, NamedPoses target, const ConvertOptions& o,
                      Conversion c) {
  SessionParts parts;
  require_links(robot, o, parts, c.notes);
  const PoseSeries& seen = target.series;
  const std::vector<double> speeds = seen.times.empty() ? std::vector<double>() : compute_speeds(seen);
  const Paired p = pair_events(of_seen_rows(joints, seen), seen.times, seen.poses.size(), speeds, o, c.notes);
  parts.joints = {joints.names, {}, p.positions};
  target = take_rows(target, p.events);
  if (c.sensor.empty()) c.sensor = target.file, c.target = target.role.empty() ? target.file : target.role;
  parts.times = target.series.times;
  NamedPoses hand = hand_of(robot, parts);
  if (tells_no_turn(target, hand.series.poses)) {
    for (const Rigid& pose : target.series.poses) parts.points.push_back({pose.translation});
    c.notes.push_back(
        message("{}: the turn of its poses is the same in every row, though the hand turns: the device measures places "
                "alone, and they are taken for points of one marker.",
                target.file));
    c.session = write_measured_session(parts, o);
    return c;
  }
  if (is_open(target)) choose_turns(hand, target, false, c.notes);
  parts.target_poses = target.series.poses;
  c.notes.push_back(sensor_note(o));
  c.session = write_measured_session(parts, o);
  return c;
}

void require_links(const FieldUrdf& robot, const ConvertOptions& o, SessionParts& parts, std::vector<Message>& notes) {
  if (o.tcp.empty())
    throw InputError(message("--tcp is missing: the link that is the hand. At the ends of this robot are: {}.",
                             shortened(fmt::format("{}", fmt::join(end_links(robot.robot), " ")), 300)));
  for (const auto& [option, name] : {std::pair("--tcp", o.tcp), std::pair("--mount", o.mount)})
    if (!name.empty() && find_link(robot.robot, name) < 0)
      throw InputError(message("{} {}: the robot has no such link; it has: {}.", option, in_quotes(name),
                               shortened(fmt::format("{}", fmt::join(link_names(robot.robot), " ")), 300)));
  parts.urdf_text = robot.text;
  parts.tcp = o.tcp;
  parts.mount = o.mount.empty() ? robot.robot.links.front().name : o.mount;
  if (o.mount.empty())
    notes.push_back(
        message("--mount is not given: the sensor is taken to stand beside the robot (link {}). Where the hand "
                "carries it: --mount {} --tcp {} (the link on which the target stands).",
                in_quotes(parts.mount), parts.tcp, parts.mount));
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
  bool one_by_one = true;
  for (const auto& row : parts.points) {
    const auto missing = static_cast<std::size_t>(std::count(row.begin(), row.end(), std::nullopt));
    unseen += missing;
    one_by_one = one_by_one && missing + 1 == row.size();
  }
  if (unseen > 0 && one_by_one)
    c.notes.push_back(message("Each line has one of {} markers.", parts.points.front().size()));
  else if (unseen > 0)
    c.notes.push_back(message("{} points were not seen by the device; they are left out.", unseen));
  c.session = write_measured_session(parts, o);
  return c;
}

}  // namespace handsight
