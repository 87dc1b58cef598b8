// SPDX-License-Identifier: Apache-2.0
#include "effects/list.h"

namespace handsight {
namespace {

void move(const ObservationState&, int place, std::span<const double> values, Sites& sites) {
  sites.robot.joints[static_cast<std::size_t>(place)].angle += values[0];
}

}  // namespace

Effect joint_offset() {
  Effect effect;
  effect.id = "joint_offset";
  effect.title = "Joint offset";
  effect.cause =
      "The angle sensor reads the same amount too much or too little in every pose: a zero position that "
      "was set a little wrong.";
  effect.visibility =
      "Seen where the joint moves the hand against the cameras; not where it only turns the body (wrist "
      "roll) or the camera (head tilt) as a whole.";
  effect.check = "Drive the joint to its mechanical stop or mark and read its angle.";
  effect.check_reads = CheckReads::number;
  effect.source = "Craig, Introduction to Robotics; Hollerbach and Wampler 1996";
  effect.scope = EffectScope::joint;
  effect.parameters = {{"offset", "rad", 5e-3}};
  effect.move = move;
  return effect;
}

}  // namespace handsight
