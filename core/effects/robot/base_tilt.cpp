// SPDX-License-Identifier: Apache-2.0
#include "effects/list.h"

namespace handsight {
namespace {

void move(const ObservationState&, int, std::span<const double> values, Sites& sites) {
  sites.robot.tilt_x += values[0];
  sites.robot.tilt_y += values[1];
}

}  // namespace

Effect base_tilt() {
  Effect effect;
  effect.id = "base_tilt";
  effect.title = "Base tilt";
  effect.cause = "The robot does not stand level: gravity comes from another direction than the model says.";
  effect.visibility = "Only through elasticity: in a model without springs it cannot be seen.";
  effect.check = "Lay a spirit level on the robot's base.";
  effect.check_reads = CheckReads::number;
  effect.source = "Authors of the calibration of DLR Justin, who read gravity from an IMU";
  effect.scope = EffectScope::session;
  effect.parameters = {{"rx", "rad", 0.02}, {"ry", "rad", 0.02}};
  effect.move = move;
  return effect;
}

}  // namespace handsight
