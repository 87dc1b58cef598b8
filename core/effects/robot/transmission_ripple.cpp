// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "effects/list.h"

namespace handsight {
namespace {

void move(const ObservationState& c, int place, std::span<const double> values, Sites& sites) {
  sites.robot.joints[static_cast<std::size_t>(place)].angle +=
      values[0] * std::sin(2 * c.sensor[place]) + values[1] * std::cos(2 * c.sensor[place]);
}

}  // namespace

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
  effect.move = move;
  return effect;
}

}  // namespace handsight
