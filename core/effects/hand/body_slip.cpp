// SPDX-License-Identifier: Apache-2.0
#include "effects/list.h"

namespace handsight {
namespace {

void move(const ObservationState& c, int, std::span<const double> values, Sites& sites) {
  if (c.order >= values[6]) sites.body += Eigen::Map<const Vector6>(values.data());
}

}  // namespace

Effect body_slip() {
  Effect effect;
  effect.id = "body_slip";
  effect.title = "Body slip";
  effect.cause = "The marker body moved on the hand at some moment: something knocked it.";
  effect.visibility = "From one observation on; needs some observations before and after.";
  effect.check = "Look whether the markers still sit where they were glued.";
  effect.check_reads = CheckReads::number;
  effect.source = "Step change in a series; Baarda 1968";
  effect.scope = EffectScope::session;
  effect.parameters = {{"x", "m", 1.5e-3},           {"y", "m", 1.5e-3},    {"z", "m", 1.5e-3},
                       {"rx", "rad", 1.5e-2},        {"ry", "rad", 1.5e-2}, {"rz", "rad", 1.5e-2},
                       {"k", "observation", 1, true}};
  effect.move = move;
  return effect;
}

}  // namespace handsight
