// SPDX-License-Identifier: Apache-2.0
#include "effects/amount.h"
#include "effects/list.h"

namespace handsight {

Effect joint_scale() {
  Effect effect;
  effect.id = "joint_scale";
  effect.title = "Joint scale";
  effect.cause =
      "The angle sensor counts a little too much or too little per turn, so that the error grows with the "
      "angle.";
  effect.visibility = "Needs a wide range of the angle; over a small range an eccentric encoder looks alike.";
  effect.check = "Turn the joint over its whole range between two marks of known angle.";
  effect.check_reads = CheckReads::turn;
  effect.source = "Hollerbach and Wampler 1996";
  effect.scope = EffectScope::joint;
  effect.parameters = {{"scale", "1", 2e-3}};
  moves_angle(effect, [](const auto& joint, const auto& number) { return number[0] * joint.q; });
  return effect;
}

}  // namespace handsight
