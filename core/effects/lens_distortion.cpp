// SPDX-License-Identifier: Apache-2.0
#include "effects/list.h"

namespace handsight {
namespace {

void move(const Circumstances&, int, std::span<const double> values, Sites& sites) {
  for (int i = 0; i < 4; ++i) {
    sites.left_camera[i + 4] += values[static_cast<std::size_t>(i)];
    sites.right_camera[i + 4] += values[static_cast<std::size_t>(i + 4)];
  }
}

}  // namespace

Effect lens_distortion() {
  Effect effect;
  effect.id = "lens_distortion";
  effect.title = "Lens distortion";
  effect.cause = "The distortion of the lenses is not that of the calibration.";
  effect.visibility = "Needs markers far from the images' middle.";
  effect.check = "Look at a straight edge near the border of the undistorted image.";
  effect.check_reads = CheckReads::image;
  effect.source = "Brown 1971";
  effect.scope = EffectScope::session;
  effect.parameters = {{"left_k1", "1", 0.03},  {"left_k2", "1", 0.03},  {"left_p1", "1", 1e-3},
                       {"left_p2", "1", 1e-3},  {"right_k1", "1", 0.03}, {"right_k2", "1", 0.03},
                       {"right_p1", "1", 1e-3}, {"right_p2", "1", 1e-3}};
  effect.move = move;
  return effect;
}

}  // namespace handsight
