// SPDX-License-Identifier: Apache-2.0
#include "effects/list.h"

namespace handsight {
namespace {

void move(const ObservationState&, int, std::span<const double> values, Sites& sites) {
  sites.cameras[1].motion += Eigen::Map<const Vector6>(values.data());
}

}  // namespace

Effect stereo_rig() {
  Effect effect = rig();  // of the second of two
  effect.id = "stereo_rig";
  effect.title = "Stereo rig";
  effect.cause = "The right camera has moved against the left one since the stereo calibration.";
  effect.scope = EffectScope::session;
  effect.move = move;
  return effect;
}

}  // namespace handsight
