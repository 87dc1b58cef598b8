// SPDX-License-Identifier: Apache-2.0
#include "effects/list.h"

namespace handsight {
namespace {

void move(const ObservationState&, int place, std::span<const double> values, Sites& sites) {
  sites.robot.joints[static_cast<std::size_t>(place)].share += values[0];
}

}  // namespace

Effect mimic_linkage() {
  Effect effect;
  effect.id = "mimic_linkage";
  effect.title = "Mimic linkage";
  effect.cause =
      "The joint that follows others is held by a tendon or a parallel linkage, not by the motors before "
      "it: its load pulls at the joints that it follows, and their deflection moves it.";
  effect.visibility =
      "Only through elasticity. Wrong names imitate it: nonlinear springs, a centre of mass, a scale, a "
      "ratio.";
  effect.check =
      "Hang a known mass on the hand and measure by how much it drops: the joints before the coupled one give way too.";
  effect.check_reads = CheckReads::drop;
  effect.source = "Virtual work on a coupled joint; tendon of the torso of DLR Justin";
  effect.scope = EffectScope::mimic_joint;
  effect.parameters = {{"share", "1", 1}};
  effect.move = move;
  return effect;
}

}  // namespace handsight
