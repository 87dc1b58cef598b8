// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "effects/amount.h"
#include "effects/coupled_joint.h"
#include "effects/list.h"

namespace handsight {

Effect joint_coupling() {
  Effect effect;
  effect.id = "joint_coupling";
  effect.title = "Joint coupling";
  effect.cause =
      "The joint turns a little with another one: a belt, a wrist or a parallelogram passes on a share of that joint's "
      "angle, and the controller does not take it back.";
  effect.visibility = "Needs wide ranges of both joints, which must not go together.";
  effect.check = "Turn the other joint alone over its whole range and watch whether this one turns.";
  effect.check_reads = CheckReads::place;
  effect.source = "Mooring, Roth and Driels 1991";
  effect.scope = EffectScope::joint;
  effect.parameters = {{"ratio", "1", 1e-2}, {"from", "joints before it", 1, true, {1, 2, 3, -1}}};
  const auto other = [](const Chain& chain, int place, std::span<const double> values) {
    return coupled_joint(chain, place, static_cast<int>(std::lround(values[1])));
  };
  moves_angle_with(effect, other, [](const auto& joint, const auto& number) { return number[0] * joint.q; });
  return effect;
}

}  // namespace handsight
