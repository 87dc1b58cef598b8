// SPDX-License-Identifier: Apache-2.0
#include "effects/list.h"

namespace handsight {
namespace {

void move(const ObservationState&, int place, std::span<const double> values, Sites& sites) {
  sites.robot.joints[static_cast<std::size_t>(place)].compliance += values[0];
}

}  // namespace

Effect joint_elasticity() {
  Effect effect;
  effect.id = "joint_elasticity";
  effect.title = "Joint elasticity";
  effect.cause =
      "The joint is a spring: its gear, its torque sensor or its controller gives way to the moment of "
      "gravity about its axis, on top of the declared stiffness. The angle sensor sits on the motor's side "
      "and does not see it.";
  effect.visibility =
      "Seen where the joint's gravity torque changes between poses; not at joints without torque. A link's "
      "torsion along the joint's axis is the same term.";
  effect.check = "Hold the arm stretched out, hang a known mass on the hand, and measure by how much the hand drops.";
  effect.check_reads = CheckReads::drop;
  effect.source = "Khalil and Besnard 2002; thesis (4.43)";
  effect.scope = EffectScope::joint;
  effect.parameters = {{"compliance", "rad/(N m)", 1e-4}};
  effect.move = move;
  return effect;
}

}  // namespace handsight
