// SPDX-License-Identifier: Apache-2.0
#include "effects/amount.h"
#include "effects/list.h"

namespace handsight {

Effect friction_hysteresis() {
  Effect effect;
  effect.id = "friction_hysteresis";
  effect.title = "Friction hysteresis";
  effect.cause = "Friction holds the joint back: it stops short on the side that it came from.";
  effect.visibility = "Poses must be approached from both sides.";
  effect.check = "Drive to one pose from above and from below and compare where the hand is.";
  effect.check_reads = CheckReads::two_sides;
  effect.source = "Armstrong-Helouvry 1991";
  effect.scope = EffectScope::joint;
  effect.parameters = {{"gap", "rad", 1e-3}};
  moves_angle(effect, [](const auto& joint, const auto& number) { return number[0] * joint.approach; });
  return effect;
}

}  // namespace handsight
