// SPDX-License-Identifier: Apache-2.0
#include "effects/list.h"

namespace handsight {
namespace {

void move(const ObservationState&, int, std::span<const double> values, Sites& sites) {
  sites.mount += Eigen::Map<const Vector6>(values.data());
}

}  // namespace

Effect camera_mount() {
  Effect effect;
  effect.id = "camera_mount";
  effect.title = "Camera mount";
  effect.cause =
      "The cameras (or the tracker) sit on their link a little beside and turned against where the model "
      "has them.";
  effect.visibility =
      "Not apart from the body when hand and cameras never turn against each other; not needed where the "
      "mount is estimated anyway.";
  effect.check = "Hold the hand still and turn the head: the hand must stay where it is.";
  effect.source = "Tsai and Lenz 1989";
  effect.scope = EffectScope::session;
  effect.parameters = {{"x", "m", 1e-2},    {"y", "m", 1e-2},    {"z", "m", 1e-2},
                       {"rx", "rad", 2e-2}, {"ry", "rad", 2e-2}, {"rz", "rad", 2e-2}};
  effect.move = move;
  return effect;
}

}  // namespace handsight
