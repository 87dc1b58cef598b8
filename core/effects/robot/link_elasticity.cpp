// SPDX-License-Identifier: Apache-2.0
#include "effects/list.h"

namespace handsight {
namespace {

void move(const ObservationState&, int place, std::span<const double> values, Sites& sites) {
  sites.robot.joints[static_cast<std::size_t>(place)].lateral_compliance += values[0];
}

}  // namespace

Effect link_elasticity() {
  Effect effect;
  effect.id = "link_elasticity";
  effect.title = "Lateral elasticity";
  effect.cause =
      "The bearing, the housing or the link behind the joint bends across the axis under the moment of "
      "gravity: transversal elasticity.";
  effect.visibility =
      "Only the part across the axes on both sides of the joint is its own; along the axis it is joint "
      "elasticity.";
  effect.check = "Stretch the arm out, hang a known mass on the hand, and measure by how much the hand drops.";
  effect.check_reads = CheckReads::drop;
  effect.source = "Caenen and Angue 1990; Khalil and Besnard 2002";
  effect.scope = EffectScope::joint;
  effect.parameters = {{"compliance", "rad/(N m)", 3e-5}};
  effect.move = move;
  return effect;
}

}  // namespace handsight
