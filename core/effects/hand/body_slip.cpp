// SPDX-License-Identifier: Apache-2.0
#include "effects/amount.h"
#include "effects/list.h"

namespace handsight {

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
  moves_body(effect, [](const auto& now, const auto& number, std::size_t axis) {
    return where(now.order >= number[6], number[axis]);
  });
  return effect;
}

}  // namespace handsight
