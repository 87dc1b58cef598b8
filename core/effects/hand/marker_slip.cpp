// SPDX-License-Identifier: Apache-2.0
#include "effects/list.h"

namespace handsight {
namespace {

void move(const ObservationState& c, int place, std::span<const double> values, Sites& sites) {
  if (c.order >= values[3]) sites.markers[static_cast<std::size_t>(place)] += Vector3(values[0], values[1], values[2]);
}

}  // namespace

Effect marker_slip() {
  Effect effect;
  effect.id = "marker_slip";
  effect.title = "Marker slip";
  effect.cause = "One marker came loose and moved on the hand.";
  effect.visibility = "From one observation on; seen in the side lengths of the markers.";
  effect.check = "Press the marker down and compare its distances to the others.";
  effect.check_reads = CheckReads::number;
  effect.source = "Step change in a series; Baarda 1968";
  effect.scope = EffectScope::marker;
  effect.parameters = {{"x", "m", 2e-3}, {"y", "m", 2e-3}, {"z", "m", 2e-3}, {"k", "observation", 1, true}};
  effect.move = move;
  return effect;
}

}  // namespace handsight
