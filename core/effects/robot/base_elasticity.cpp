// SPDX-License-Identifier: Apache-2.0
#include "effects/list.h"

namespace handsight {
namespace {

void move(const ObservationState&, int, std::span<const double> values, Sites& sites) {
  sites.robot.base_compliance += Vector3(values[0], values[1], values[2]);
}

}  // namespace

Effect base_elasticity() {
  Effect effect;
  effect.id = "base_elasticity";
  effect.title = "Base elasticity";
  effect.cause = "The robot's foot gives way: the whole robot tips with the moment of gravity about its base.";
  effect.visibility = "Seen only by a camera or a tracker that does not ride on the robot.";
  effect.check = "Stretch the arm to one side, hang a known mass on the hand, and measure by how much the hand drops.";
  effect.check_reads = CheckReads::drop;
  effect.source = "Khalil and Besnard 2002, the spring put at the root";
  effect.scope = EffectScope::session;
  effect.parameters = {{"xx", "rad/(N m)", 3e-5}, {"xy", "rad/(N m)", 3e-5}, {"yy", "rad/(N m)", 3e-5}};
  effect.move = move;
  return effect;
}

}  // namespace handsight
