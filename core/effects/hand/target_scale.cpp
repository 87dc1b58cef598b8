// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "effects/list.h"
#include "effects/target_effects.h"

namespace handsight {

Effect target_scale() {
  Effect effect;
  effect.id = "target_scale";
  effect.title = "Size of the target";
  effect.cause =
      "The target was printed larger or smaller than its description says (a printer that fits the page, or a length "
      "typed wrong), so that every distance seen is wrong by the same share.";
  effect.visibility =
      "Needs poses at several distances or positions; where the target's points are free it is not needed.";
  effect.check = "Measure the target over its whole length with a ruler and compare with its description.";
  effect.check_reads = CheckReads::number;
  effect.source = "Zhang 2000";
  effect.scope = EffectScope::session;
  effect.parameters = {{"scale", "1", 2e-2}};
  effect.move = move_no_target;
  return effect;
}

Effect target_scale(std::vector<Vector3> in_body) {
  Effect effect = target_scale();
  effect.move = [points = std::move(in_body)](const ObservationState&, int, std::span<const double> values,
                                              Sites& sites) {
    const std::size_t count = std::min(points.size(), sites.markers.size());
    for (std::size_t m = 0; m < count; ++m) sites.markers[m] += values[0] * points[m];
  };
  return effect;
}

Effect target_scale_of_poses(std::vector<Vector3> in_sensor_by_order) {
  Effect effect = target_scale();
  // A target larger by a share stands farther away by it than the sensor says: as if the sensor had come nearer.
  effect.move = [places = std::move(in_sensor_by_order)](const ObservationState& c, int, std::span<const double> values,
                                                         Sites& sites) {
    const auto order = static_cast<std::size_t>(c.order);
    if (order < places.size()) sites.drift.head<3>() += values[0] * places[order];
  };
  return effect;
}

}  // namespace handsight
