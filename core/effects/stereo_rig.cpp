// SPDX-License-Identifier: Apache-2.0
#include "effects/list.h"

namespace handsight {
namespace {

void move(const Circumstances&, int, std::span<const double> values, Sites& sites) {
  sites.cameras[1].motion += Eigen::Map<const Vector6>(values.data());
}

}  // namespace

Effect stereo_rig() {
  Effect effect;
  effect.id = "stereo_rig";
  effect.title = "Stereo rig";
  effect.cause = "The right camera has moved against the left one since the stereo calibration.";
  effect.visibility = "Near to the principal points; needs a range of depth and the corners of the images.";
  effect.check = "Look at the epipolar distances of any matched points: they ought to be zero.";
  effect.check_reads = CheckReads::epipolar;
  effect.source = "Hartley and Zisserman";
  effect.scope = EffectScope::session;
  effect.parameters = {{"x", "m", 1e-3},    {"y", "m", 1e-3},    {"z", "m", 1e-3},
                       {"rx", "rad", 2e-3}, {"ry", "rad", 2e-3}, {"rz", "rad", 2e-3}};
  effect.move = move;
  return effect;
}

}  // namespace handsight
