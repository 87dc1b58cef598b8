// SPDX-License-Identifier: Apache-2.0
// The parts of a hand program: joints, moves, and the program that they make.
#pragma once

#include <string>
#include <vector>

#include "export/expression.h"
#include "robot/robot.h"

namespace handsight {

/// A joint and what it carries: its link, all links fixed to that, their masses together. Parents come first.
struct ProgramJoint {
  std::string name;
  JointKind kind = JointKind::fixed;  // fixed: the frame of all that is fixed to the root
  int parent = -1;                    // -1: the floor
  Rigid parent_from_joint;
  Vector3 axis = Vector3::UnitZ();
  Rigid joint_from_child;
  double stiffness = 0;  // N m/rad (N/m), 0: rigid
  double mass = 0;
  Vector3 moment = Vector3::Zero();  // kg m, mass * centre, in the child's frame
  std::vector<Mimic> mimics;         // of joints of the program
  int input = -1;                    // place in a position; -1: none, stands at 0 or follows others
  double lower = -1e30, upper = 1e30;
};

/// "joint[3].angle += 0.002 * q[3]": `target` is a number of the program, the same in every language.
struct ProgramMove {
  std::string target;
  Expression amount;
  std::string of;  // "joint_scale of arm_2"
};

struct HandProgram {
  std::string title;  // of the session
  std::string created;
  std::vector<std::string> inputs;  // joint names, the order of a position
  std::vector<ProgramJoint> joints;
  std::vector<int> value_order;  // of joints: those that are followed before those that follow
  std::vector<ProgramMove> moves;
  std::vector<std::string> left_out;      // effects that do not move the hand: cameras, markers; a sentence each
  Vector3 root_moment = Vector3::Zero();  // kg m, of the root link itself
  Vector3 gravity = Vector3::Zero();
  int tcp = -1;  // the joint that carries the TCP link; -1: the root link itself
  Rigid child_from_tcp;
  int mount = -1;  // the same of the link that carries the sensor; of use where formulas read the TCP's place
  Rigid child_from_mount;
  Vector3 center_in_tcp = Vector3::Zero();  // m, of the TCP link's declared mass: where a payload hangs
  Rigid tcp_from_body;
  bool nominal_is_elastic = false, is_elastic = false, reads_torque = false, reads_place = false;
};

}  // namespace handsight
