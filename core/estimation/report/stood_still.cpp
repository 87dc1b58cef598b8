// SPDX-License-Identifier: Apache-2.0
#include "estimation/report/stood_still.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "robot/robot.h"

namespace handsight {
namespace {

constexpr double equal = 1e-9;  // m, rad, px
constexpr double moved_m = 2e-3, moved_rad = 0.01, moved_px = 5;

/// How far something moved, in units of what is clearly more than noise.
struct Way {
  bool is_known = false, is_none = false;
  double size = 0;
};

Way pose_way(const Rigid& a, const Rigid& b) {
  const double shift = (a.translation - b.translation).norm(),
               turn = vector_from_rotation(Matrix3(a.rotation.transpose() * b.rotation)).norm();
  return {true, shift < equal && turn < 1e-7, std::max(shift / moved_m, turn / moved_rad)};
}

Way robot_way(const Session& s, const Observation& a, const Observation& b) {
  if (s.robot.is_of_poses) return pose_way(base_from_flange(a.position), base_from_flange(b.position));
  const double largest = (a.position - b.position).cwiseAbs().maxCoeff();
  return {true, largest < equal, largest / moved_rad};
}

Way sighting_way(const Sighting& a, const Sighting& b) {
  if (a.point && b.point) {
    const double shift = (*a.point - *b.point).norm();
    return {true, shift < equal, shift / moved_m};
  }
  Way way;
  for (const CameraPoint& first : a.in_cameras) {
    const CameraPoint* second = seen_by(b, first.camera);
    if (!second) continue;
    const double shift = (first.pixel - second->pixel).norm();
    way.is_none = (way.is_known ? way.is_none : true) && shift < equal;
    way.is_known = true;
    way.size = std::max(way.size, shift / moved_px);
  }
  return way;
}

/// By the target's pose, or by all markers that both show: the least of their ways, so that one wrong point is none.
Way seen_way(const Observation& a, const Observation& b) {
  if (a.target_pose && b.target_pose) return pose_way(*a.target_pose, *b.target_pose);
  Way all{false, true, 1e300};
  auto other = b.sightings.begin();  // both are in order of marker
  for (const Sighting& s : a.sightings) {
    while (other != b.sightings.end() && other->marker < s.marker) ++other;
    if (other == b.sightings.end() || other->marker != s.marker) continue;
    const Way way = sighting_way(s, *other);
    if (way.is_known) all = {true, all.is_none && way.is_none, std::min(all.size, way.size)};
  }
  return all;
}

Message listed(const std::vector<Message>& pairs) { return at_most(joined(pairs), 150); }

/// A socket is where it was.
bool is_touch(const Session& session, const Observation& o) {
  return !session.parts.empty() && session.parts[static_cast<std::size_t>(o.part)].fixture >= 0;
}

}  // namespace

std::vector<Message> standstill_warnings(const Session& session) {
  std::vector<Message> robot_stood, sight_stood, warnings;
  if (session.joints.empty() || session.is_touch()) return warnings;
  for (std::size_t i = 1; i < session.observations.size(); ++i) {
    const Observation &a = session.observations[i - 1], &b = session.observations[i];
    if (!is_used(a) || !is_used(b) || is_touch(session, a) || is_touch(session, b)) continue;
    const Way robot = robot_way(session, a, b), seen = seen_way(a, b);
    if (!seen.is_known) continue;
    const Message pair = message("{} and {}", a.id, b.id);
    if (robot.is_none && seen.size > 1) robot_stood.push_back(pair);
    if (seen.is_none && robot.size > 1) sight_stood.push_back(pair);
  }
  if (robot_stood.size() + 1 == session.observations.size()) robot_stood.clear();  // all are one pose: told as that
  if (!robot_stood.empty())
    warnings.push_back(
        session.robot.is_of_poses
            ? message("The pose of the flange is the same in observations {}, while what was seen moved: the "
                      "reading of one is old, or something slipped between them; leave out what is wrong.",
                      listed(robot_stood))
            : message("The joint readings are the same in observations {}, while what was seen moved: the reading "
                      "of one is old, or something slipped between them; leave out what is wrong.",
                      listed(robot_stood)));
  if (2 * sight_stood.size() > session.observations.size())
    warnings.push_back(message(
        "What was seen is the same in {} of {} observations as in the one before, while the robot moved: right where "
        "the hand was held in one place, as in a socket; else the sensor stood still.",
        sight_stood.size(), session.observations.size()));
  else if (!sight_stood.empty())
    warnings.push_back(
        message("What was seen is the same in observations {}, while the robot moved: the measurement of one is "
                "old. Leave it out.",
                listed(sight_stood)));
  return warnings;
}

}  // namespace handsight
