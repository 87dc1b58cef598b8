// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "effects/amount.h"
#include "effects/list.h"

namespace handsight {

Effect transmission_ripple() {
  Effect effect;
  effect.id = "transmission_ripple";
  effect.title = "Transmission ripple";
  effect.cause =
      "The gear does not turn evenly: the error swings twice per turn of the joint, as a harmonic drive "
      "does.";
  effect.visibility = "Needs a quarter turn or more; other orders only where they are asked for.";
  effect.check = "Turn the joint slowly by a full turn and compare motor and joint angle.";
  effect.check_reads = CheckReads::turn;
  effect.source = "Tuttle 1992 on harmonic drives";
  effect.scope = EffectScope::joint;
  effect.parameters = {{"sine", "rad", 1e-3}, {"cosine", "rad", 1e-3}};
  moves_angle(effect, [](const auto& joint, const auto& number) {
    using std::sin, std::cos;
    return number[0] * sin(2 * joint.q) + number[1] * cos(2 * joint.q);
  });
  return effect;
}

}  // namespace handsight
