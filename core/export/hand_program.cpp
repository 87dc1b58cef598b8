// SPDX-License-Identifier: Apache-2.0
#include "export/hand_program.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "export/program_moves.h"

namespace handsight {
namespace {

/// Where a link's frame sits: the moving joint that carries it (-1: fixed to the root) and the fixed way from there.
struct Carried {
  int joint = -1;
  Rigid from_link;  // the joint's child frame, or the root's, from the link's frame
};

std::vector<Carried> carriers(const Robot& robot) {
  std::vector<Carried> all(robot.links.size());
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const Joint& joint = robot.joints[j];
    Carried& child = all[static_cast<std::size_t>(joint.child_link)];
    const Carried& parent = all[static_cast<std::size_t>(joint.parent_link)];
    if (joint.moves()) {
      child = {static_cast<int>(j), Rigid{}};
    } else {
      child = {parent.joint, parent.from_link * joint.parent_from_joint * joint.joint_from_child};
    }
  }
  return all;
}

/// The joints that the hand depends on: those that carry it, with springs all that loads them, where formulas read its
/// place those that carry the sensor, and what these follow.
std::vector<char> needed_joints(const CalibratedRobot& robot, bool has_loads, bool reads_place) {
  const Robot& r = robot.chain.robot;
  std::vector<char> needed(r.joints.size(), 0);
  for (const int j : joints_to(r, robot.chain.tcp_link)) needed[static_cast<std::size_t>(j)] = 1;
  if (reads_place)
    for (const int j : joints_to(r, robot.chain.mount_link)) needed[static_cast<std::size_t>(j)] = 1;
  for (const int j : joints_read_by_name(robot)) needed[static_cast<std::size_t>(j)] = 1;
  if (has_loads) {
    std::vector<char> carries(r.joints.size(), 0);
    for (std::size_t j = r.joints.size(); j-- > 0;) {
      if (r.links[static_cast<std::size_t>(r.joints[j].child_link)].mass > 0) carries[j] = 1;
      const int above = r.links[static_cast<std::size_t>(r.joints[j].parent_link)].parent_joint;
      if (above >= 0 && carries[j]) carries[static_cast<std::size_t>(above)] = 1;
      needed[j] = needed[j] || carries[j];
    }
  }
  for (bool has_new = true; has_new;) {
    has_new = false;
    for (std::size_t j = 0; j < needed.size(); ++j)
      for (const Mimic& m : r.joints[j].mimics) {
        char& followed = needed[static_cast<std::size_t>(m.joint)];
        has_new = has_new || (needed[j] && !followed);
        followed = followed || needed[j];
      }
    // What a joint hangs on has its place in the program too.
    for (std::size_t j = needed.size(); j-- > 0;) {
      const int above = r.links[static_cast<std::size_t>(r.joints[j].parent_link)].parent_joint;
      if (!needed[j] || above < 0 || needed[static_cast<std::size_t>(above)]) continue;
      needed[static_cast<std::size_t>(above)] = has_new = true;
    }
  }
  return needed;
}

/// Adds a link's mass to the joint that carries it.
void add_mass(ProgramJoint& joint, const Link& link, const Rigid& child_from_link) {
  joint.mass += link.mass;
  joint.moment += link.mass * (child_from_link * link.center_of_mass);
}

std::vector<int> followed_first(const std::vector<ProgramJoint>& joints) {
  std::vector<int> order;
  std::vector<char> done(joints.size(), 0);
  const auto visit = [&](auto&& self, int j) -> void {
    if (done[static_cast<std::size_t>(j)]) return;
    done[static_cast<std::size_t>(j)] = 1;
    for (const Mimic& m : joints[static_cast<std::size_t>(j)].mimics) self(self, m.joint);
    order.push_back(j);
  };
  for (std::size_t j = 0; j < joints.size(); ++j) visit(visit, static_cast<int>(j));
  return order;
}

/// Places in the program of the robot's joints, -1 where they are not needed. The first of the program carries what is
/// fixed to the root.
std::vector<int> set_joints(const CalibratedRobot& robot, const std::vector<char>& needed, HandProgram& program) {
  const Robot& r = robot.chain.robot;
  const std::vector<Carried> carried = carriers(r);
  program.joints = {ProgramJoint{.name = "what is fixed to the root"}};
  std::vector<int> place(r.joints.size(), -1);
  for (std::size_t j = 0; j < r.joints.size(); ++j) {
    const Joint& joint = r.joints[j];
    if (!joint.moves() || !needed[j]) continue;
    const Carried& parent = carried[static_cast<std::size_t>(joint.parent_link)];
    ProgramJoint p{joint.name, joint.kind};
    p.parent = parent.joint < 0 ? 0 : place[static_cast<std::size_t>(parent.joint)];
    p.parent_from_joint = parent.from_link * joint.parent_from_joint;
    p.axis = joint.axis;
    p.joint_from_child = joint.joint_from_child;
    p.stiffness = joint.stiffness;
    p.lower = joint.lower;
    p.upper = joint.upper;
    place[j] = static_cast<int>(program.joints.size());
    program.joints.push_back(std::move(p));
  }
  for (std::size_t j = 0; j < r.joints.size(); ++j)
    if (place[j] >= 0)
      for (const Mimic& m : r.joints[j].mimics)
        program.joints[static_cast<std::size_t>(place[j])].mimics.push_back(
            {place[static_cast<std::size_t>(m.joint)], m.multiplier, m.offset});
  for (std::size_t i = 0; i < robot.chain.joints.size(); ++i) {
    const int at = place[static_cast<std::size_t>(robot.chain.joints[i])];
    if (at >= 0) program.joints[static_cast<std::size_t>(at)].input = static_cast<int>(i);
  }
  for (std::size_t l = 1; l < r.links.size(); ++l) {
    const int by = carried[l].joint;
    const int at = by < 0 ? 0 : place[static_cast<std::size_t>(by)];
    if (at >= 0) add_mass(program.joints[static_cast<std::size_t>(at)], r.links[l], carried[l].from_link);
  }
  const auto carrier = [&](std::size_t link) {
    const int by = carried[link].joint;
    return link == 0 ? -1 : by < 0 ? 0 : place[static_cast<std::size_t>(by)];
  };
  const auto tcp = static_cast<std::size_t>(robot.chain.tcp_link),
             mount = static_cast<std::size_t>(robot.chain.mount_link);
  program.tcp = carrier(tcp);
  program.child_from_tcp = carried[tcp].from_link;
  if (program.reads_place) {
    program.mount = carrier(mount);
    program.child_from_mount = carried[mount].from_link;
  }
  program.center_in_tcp = r.links[tcp].center_of_mass;
  program.root_moment = r.links[0].mass * r.links[0].center_of_mass;
  return place;
}

}  // namespace

HandProgram hand_program(const CalibratedRobot& calibrated) {
  const CalibratedRobot robot = with_moved_hand(calibrated);
  HandProgram program;
  program.title = robot.calibration.session;
  program.created = robot.calibration.created;
  program.inputs = robot.joint_names;
  program.gravity = robot.chain.gravity;
  program.tcp_from_body = robot.model.tcp_from_body;
  const Robot& r = robot.chain.robot;
  program.nominal_is_elastic =
      std::any_of(r.joints.begin(), r.joints.end(), [](const Joint& j) { return j.moves() && j.stiffness > 0; });
  const auto reads = [&](bool Effect::*flag) {
    return std::any_of(robot.model.effects.begin(), robot.model.effects.end(),
                       [&](const EffectTerm& t) { return term_effect(t).*flag; });
  };
  program.reads_torque = reads(&Effect::reads_torque);
  program.reads_place = reads(&Effect::reads_place);
  program.is_elastic = program.nominal_is_elastic || bends(robot);
  const std::vector<int> place =
      set_joints(robot, needed_joints(robot, program.is_elastic || program.reads_torque, program.reads_place), program);
  program.value_order = followed_first(program.joints);
  add_moves(robot, place, program);
  return program;
}

}  // namespace handsight
