// SPDX-License-Identifier: Apache-2.0
#include "effects/list.h"

namespace handsight {
namespace {

void move(const ObservationState&, int place, std::span<const double> values, Sites& sites) {
  sites.robot.joints[static_cast<std::size_t>(place)].multiplier_error += values[0];
  sites.robot.joints[static_cast<std::size_t>(place)].angle += values[1];
}

}  // namespace

Effect mimic_error() {
  Effect effect;
  effect.id = "mimic_error";
  effect.title = "Mimic error";
  effect.cause = "The joint that follows others does so in a slightly other ratio, or from another zero.";
  effect.visibility = "Not where head and arm both hang behind the coupled joint, but for gravity.";
  effect.check =
      "Move the followed joints through their range and lay a level on the link that ought to keep its "
      "direction.";
  effect.check_reads = CheckReads::number;
  effect.source = "Error of a coupling ratio and its zero";
  effect.scope = EffectScope::mimic_joint;
  effect.parameters = {{"error", "1", 5e-3}, {"offset", "rad", 5e-3}};
  effect.move = move;
  return effect;
}

}  // namespace handsight
