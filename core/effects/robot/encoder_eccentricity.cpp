// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "effects/amount.h"
#include "effects/list.h"

namespace handsight {

Effect encoder_eccentricity() {
  Effect effect;
  effect.id = "encoder_eccentricity";
  effect.title = "Encoder eccentricity";
  effect.cause = "The encoder's disc is not centred on the axis: the error swings once per turn.";
  effect.visibility =
      "Always a pair of sine and cosine; needs about half a turn of the joint to be told from a scale or an "
      "offset.";
  effect.check = "Turn the joint by a full turn against an index table.";
  effect.check_reads = CheckReads::turn;
  effect.source = "Standard error model of angular encoders";
  effect.scope = EffectScope::joint;
  effect.parameters = {{"sine", "rad", 2e-3}, {"cosine", "rad", 2e-3}};
  moves_angle(effect, [](const auto& joint, const auto& number) {
    using std::sin, std::cos;
    return number[0] * sin(joint.q) + number[1] * cos(joint.q);
  });
  return effect;
}

}  // namespace handsight
