// SPDX-License-Identifier: Apache-2.0
#include "effects/list.h"

namespace handsight {
namespace {

void move(const ObservationState& c, int, std::span<const double> values, Sites& sites) {
  if (c.order >= values[6]) sites.drift += Eigen::Map<const Vector6>(values.data());
}

}  // namespace

Effect mount_slip() {
  Effect effect;
  effect.id = "mount_slip";
  effect.title = "Mount slip";
  effect.cause =
      "The cameras or the tracker, their stand, or a fixture jumped at some moment: something knocked it or came "
      "loose.";
  effect.visibility = "From one observation on; needs some observations before and after.";
  effect.check = "Look at something that stands still before and after, or measure the first pose again.";
  effect.check_reads = CheckReads::number;
  effect.source = "Step change in a series; Baarda 1968";
  effect.scope = EffectScope::session;
  effect.parameters = {{"x", "m", 1.5e-3},  {"y", "m", 1.5e-3},  {"z", "m", 1.5e-3},           {"rx", "rad", 3e-3},
                       {"ry", "rad", 3e-3}, {"rz", "rad", 3e-3}, {"k", "observation", 1, true}};
  effect.move = move;
  return effect;
}

}  // namespace handsight
