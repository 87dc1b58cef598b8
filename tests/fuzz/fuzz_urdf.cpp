// SPDX-License-Identifier: Apache-2.0
// A URDF is read to a tree of finite numbers, or refused with a sentence.
#include "fuzz.h"
#include "robot/urdf.h"

namespace handsight {
namespace {

void demand_tree(const Robot& robot) {
  demand(robot.links.size() == robot.joints.size() + 1, "one joint more makes one link more");
  demand(robot.links[0].parent_joint == -1, "the first link is the root");
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const Joint& joint = robot.joints[j];
    demand(joint.parent_link >= 0 && joint.parent_link < joint.child_link, "parents come before children", joint.name);
    demand(robot.links[static_cast<std::size_t>(joint.child_link)].parent_joint == static_cast<int>(j),
           "links know their joint", joint.name);
    demand(std::abs(joint.axis.norm() - 1) < 1e-12, "axes are unit vectors", joint.name);
    demand(joint.parent_from_joint.rotation.allFinite() && joint.parent_from_joint.translation.allFinite(),
           "finite frames", joint.name);
    demand(joint.stiffness >= 0 && joint.lower <= joint.upper, "stiffness and limits", joint.name);
    for (const Mimic& mimic : joint.mimics)
      demand(robot.joints.at(static_cast<std::size_t>(mimic.joint)).moves(), "mimics follow joints that move",
             joint.name);
  }
}

}  // namespace
}  // namespace handsight

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    std::vector<handsight::Message> notes;
    handsight::demand_tree(
        handsight::parse_urdf(std::string(reinterpret_cast<const char*>(data), size), "robot.urdf", &notes));
    for (const std::string& note : notes)
      handsight::demand(handsight::is_utf8(note) && note.size() <= 600, "notes are short", note);
  } catch (const handsight::InputError& error) {
    handsight::demand_sentence(error);
  }
  return 0;
}
