// SPDX-License-Identifier: Apache-2.0
#include "effects/coupled_joint.h"

#include <algorithm>
#include <cmath>

namespace handsight {
namespace {

const Joint& joint_at(const Robot& robot, int joint) { return robot.joints[static_cast<std::size_t>(joint)]; }

int joint_above(const Robot& robot, int link) { return robot.links[static_cast<std::size_t>(link)].parent_joint; }

/// The next moving joint from a link towards the root, the joint above the link included; -1: none.
int moving_above(const Robot& robot, int link) {
  int joint = joint_above(robot, link);
  while (joint >= 0 && !joint_at(robot, joint).moves()) joint = joint_above(robot, joint_at(robot, joint).parent_link);
  return joint;
}

int moving_before(const Robot& robot, int joint) { return moving_above(robot, joint_at(robot, joint).parent_link); }

int moved_towards_root(const Robot& robot, int joint, int places) {
  for (; places > 0 && joint >= 0; --places) joint = moving_before(robot, joint);
  return joint;
}

/// The joint so many places farther from the root on the way to `end`; -1: none.
int moved_towards(const Robot& robot, int end, int joint, int places) {
  for (int other = moving_above(robot, end); other >= 0; other = moving_before(robot, other))
    if (moved_towards_root(robot, other, places) == joint) return other;
  return -1;
}

bool follows(const Robot& robot, int one, int other) {
  const std::vector<Mimic>& mimics = joint_at(robot, one).mimics;
  return std::any_of(mimics.begin(), mimics.end(), [&](const Mimic& m) { return m.joint == other; });
}

}  // namespace

std::optional<int> coupled_joint(const Chain& chain, int joint, int before) {
  const Robot& robot = chain.robot;
  int other = -1;
  if (before > 0) other = moved_towards_root(robot, joint, before);
  for (const int end : {chain.tcp_link, chain.mount_link})
    if (before < 0 && other < 0) other = moved_towards(robot, end, joint, -before);
  if (other < 0 || follows(robot, joint, other) || follows(robot, other, joint)) return std::nullopt;
  return other;
}

std::optional<int> coupled_joint(const Chain& chain, const EffectTerm& term) {
  if (term.id != "joint_coupling") return std::nullopt;
  return coupled_joint(chain, term.place, static_cast<int>(std::lround(term.values.at(1))));
}

}  // namespace handsight
