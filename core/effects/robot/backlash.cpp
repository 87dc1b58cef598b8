// SPDX-License-Identifier: Apache-2.0
#include "effects/list.h"

namespace handsight {
namespace {

void move(const ObservationState&, int place, std::span<const double> values, Sites& sites) {
  sites.robot.joints[static_cast<std::size_t>(place)].gap += values[0];
}

}  // namespace

Effect backlash() {
  Effect effect;
  effect.id = "backlash";
  effect.title = "Backlash";
  effect.cause =
      "The gear has play: the joint rests on one flank or the other, depending on the sign of gravity's "
      "torque.";
  effect.visibility = "Not where the torque never changes its sign: there it is an offset.";
  effect.check = "Hold the motor and rock the link by hand in both directions; read the play at the hand.";
  effect.check_reads = CheckReads::two_sides;
  effect.source = "Slotine and Li; Khalil and Dombre 2002";
  effect.scope = EffectScope::joint;
  effect.parameters = {{"gap", "rad", 1e-3}};
  effect.move = move;
  return effect;
}

}  // namespace handsight
