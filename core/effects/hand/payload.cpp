// SPDX-License-Identifier: Apache-2.0
#include "effects/list.h"

namespace handsight {
namespace {

void move(const ObservationState& c, int, std::span<const double> values, Sites& sites) {
  sites.robot.payload_link = c.chain->tcp_link;
  sites.robot.payload_mass += values[0];
  sites.robot.payload_moment += Vector3(values[1], values[2], values[3]);
}

}  // namespace

Effect payload() {
  Effect effect;
  effect.id = "payload";
  effect.title = "Payload";
  effect.cause =
      "The hand carries a mass that the model does not know, or its centre of mass is elsewhere: the "
      "springs are loaded differently.";
  effect.visibility = "Only through elasticity: in a model without springs it cannot be seen.";
  effect.check = "Weigh the hand with everything on it.";
  effect.check_reads = CheckReads::number;
  effect.source = "Swevers et al. 2007";
  effect.scope = EffectScope::session;
  effect.parameters = {
      {"mass", "kg", 1}, {"moment_x", "kg m", 0.03}, {"moment_y", "kg m", 0.03}, {"moment_z", "kg m", 0.03}};
  effect.move = move;
  return effect;
}

}  // namespace handsight
