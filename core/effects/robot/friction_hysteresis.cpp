// SPDX-License-Identifier: Apache-2.0
#include "effects/list.h"

namespace handsight {
namespace {

void move(const ObservationState& c, int place, std::span<const double> values, Sites& sites) {
  sites.robot.joints[static_cast<std::size_t>(place)].angle += values[0] * c.approach[place];
}

}  // namespace

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
  effect.move = move;
  return effect;
}

}  // namespace handsight
