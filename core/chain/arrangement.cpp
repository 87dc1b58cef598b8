// SPDX-License-Identifier: Apache-2.0
#include "chain/arrangement.h"

#include <algorithm>
#include <vector>

#include "base/error.h"

namespace handsight {
namespace {

/// The joints between the root and a link that take part in a pose: measured ones, and those that mimic.
std::vector<int> moving_joints(const Chain& chain, int link) {
  std::vector<int> joints;
  for (int j = chain.robot.links[static_cast<std::size_t>(link)].parent_joint; j >= 0;) {
    const Joint& joint = chain.robot.joints[static_cast<std::size_t>(j)];
    const bool is_measured = std::find(chain.joints.begin(), chain.joints.end(), j) != chain.joints.end();
    if (joint.moves() && (is_measured || joint.is_mimic())) joints.push_back(j);
    j = chain.robot.links[static_cast<std::size_t>(joint.parent_link)].parent_joint;
  }
  return joints;
}

/// Joints of one way that are not on the other.
bool has_own(const std::vector<int>& joints, const std::vector<int>& others) {
  return std::any_of(joints.begin(), joints.end(),
                     [&](int j) { return std::find(others.begin(), others.end(), j) == others.end(); });
}

const char* sensor_of(const Session& session) {
  if (session.pose_sensor) return "sensor";
  if (!session.rig) return "tracker";
  return session.rig->count() == 1 ? "camera" : "cameras";
}

const char* target_of(const Session& session) {
  if (session.pose_sensor) return "a target";
  if (!session.target) return session.marker_count == 1 ? "a marker" : "markers";
  if (has_places(*session.target)) return is_tag_grid(*session.target) ? "a board" : "a body of tags";
  if (session.target->kind == TargetKind::tags) return session.target->ids.size() == 1 ? "a tag" : "tags";
  return "a board";
}

}  // namespace

Arrangement find_arrangement(const Chain& chain) {
  const std::vector<int> target = moving_joints(chain, chain.tcp_link), sensor = moving_joints(chain, chain.mount_link);
  const bool target_moves = has_own(target, sensor), sensor_moves = has_own(sensor, target);
  if (target_moves && sensor_moves) return Arrangement::both_move;
  if (target_moves) return Arrangement::sensor_stands;
  return sensor_moves ? Arrangement::sensor_on_hand : Arrangement::nothing_moves;
}

Message arrangement_sentence(const Session& session, const Chain& chain) {
  const Message sensor = sensor_of(session), target = target_of(session);
  switch (find_arrangement(chain)) {
    case Arrangement::sensor_stands:
      return message("The {} on {} {} {} that the robot moves on {}.", sensor, session.mount.link,
                     sensor == "cameras" ? "see" : "sees", target, session.tcp);
    case Arrangement::sensor_on_hand:
      return message("The robot moves the {} on {} over {} on {}.", sensor, session.mount.link, target, session.tcp);
    case Arrangement::both_move:
      return message("The robot moves both the {} on {} and {} on {}.", sensor, session.mount.link, target,
                     session.tcp);
    case Arrangement::nothing_moves:
      break;
  }
  return message("No measured joint moves the {} on {} against {} on {}: nothing can be told of where they are.",
                 sensor, session.mount.link, target, session.tcp);
}

std::string advice_on(Arrangement arrangement) {
  switch (arrangement) {
    case Arrangement::sensor_stands:
      return "Fix the camera where it sees the hand in many postures, and fasten the target to the hand so that it "
             "cannot slip; turn the hand as far as the target can be seen.";
    case Arrangement::sensor_on_hand:
      return "Fasten the camera to the hand and lay the target on the table where nothing moves it; look at it from "
             "all "
             "sides, near and far, and turn the hand about the line of sight.";
    case Arrangement::both_move:
      return "Move the head as well as the arm: a joint that stands still in all observations cannot be told from the "
             "mount.";
    case Arrangement::nothing_moves:
      break;
  }
  return "Name the link that carries the camera and the link that carries the target; a measured joint must lie "
         "between "
         "them.";
}

}  // namespace handsight
