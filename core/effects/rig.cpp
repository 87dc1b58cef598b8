// SPDX-License-Identifier: Apache-2.0
#include "effects/list.h"
#include "effects/rig_effects.h"

namespace handsight {
namespace {

void move(const ObservationState&, int camera, std::span<const double> values, Sites& sites) {
  sites.cameras[static_cast<std::size_t>(camera)].motion += Eigen::Map<const Vector6>(values.data());
}

}  // namespace

Effect rig() {
  Effect effect;
  effect.id = "rig";
  effect.title = "Camera moved in its rig";
  effect.cause =
      "A camera has moved against the first one since the rig was calibrated; of a rig of two the effect is "
      "called stereo_rig.";
  effect.visibility = "Near to the principal points; needs a range of depth and the corners of the images.";
  effect.check = "Look at the epipolar distances of any matched points: they ought to be zero.";
  effect.check_reads = CheckReads::epipolar;
  effect.source = "Hartley and Zisserman";
  effect.scope = EffectScope::camera;
  effect.parameters = {{"x", "m", 1e-3},    {"y", "m", 1e-3},    {"z", "m", 1e-3},
                       {"rx", "rad", 2e-3}, {"ry", "rad", 2e-3}, {"rz", "rad", 2e-3}};
  effect.move = move;
  return effect;
}

Effect rig_motions(const Rig& cameras) {
  Effect effect = rig();
  effect.cameras = camera_names(cameras);
  effect.cameras.front().clear();
  return effect;
}

}  // namespace handsight
