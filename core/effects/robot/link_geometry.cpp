// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "effects/list.h"

namespace handsight {
namespace {

/// Two directions across the axis: u from x (from y where the axis is near x), w = axis cross u.
void move(const ObservationState& c, int place, std::span<const double> values, Sites& sites) {
  const Vector3& axis = c.chain->robot.joints[static_cast<std::size_t>(place)].axis;
  const Vector3 start = std::abs(axis.x()) >= 0.9 ? Vector3::UnitY() : Vector3::UnitX();
  const Vector3 u = (start - axis * axis.dot(start)).normalized();
  const Vector3 w = axis.cross(u);
  Vector6 motion;
  motion << values[0] * u + values[1] * w, values[2] * u + values[3] * w;
  sites.robot.joints[static_cast<std::size_t>(place)].frame += motion;
}

}  // namespace

Effect link_geometry() {
  Effect effect;
  effect.id = "link_geometry";
  effect.title = "Link geometry";
  effect.cause =
      "The joint does not sit quite where the drawing puts it: its axis is shifted and tilted a little "
      "against the link before it.";
  effect.visibility =
      "Alone it is the whole geometry, four numbers a joint; a large offset of one joint is better called "
      "joint offset.";
  effect.check = "Measure the axis with a dial gauge or a tracker while only this joint turns.";
  effect.check_reads = CheckReads::number;
  effect.source = "Hayati and Mirmirani 1985; Craig 1989";
  effect.scope = EffectScope::joint;
  effect.parameters = {{"tu", "m", 1e-3}, {"tw", "m", 1e-3}, {"ru", "rad", 3e-3}, {"rw", "rad", 3e-3}};
  effect.move = move;
  return effect;
}

}  // namespace handsight
