// SPDX-License-Identifier: Apache-2.0
#include "effects/list.h"

namespace handsight {
namespace {

void move(const Circumstances&, int, std::span<const double> values, Sites& sites) {
  for (int i = 0; i < 4; ++i) {
    sites.left_camera[i] += values[static_cast<std::size_t>(i)];
    sites.right_camera[i] += values[static_cast<std::size_t>(i + 4)];
  }
}

}  // namespace

Effect camera_intrinsics() {
  Effect effect;
  effect.id = "camera_intrinsics";
  effect.title = "Camera intrinsics";
  effect.cause =
      "Focal lengths and principal points of the cameras are not those of the calibration: the focus was "
      "turned, or the lens was knocked.";
  effect.visibility = "Needs the range of depth and the corners of the images.";
  effect.check = "Calibrate the cameras again with a board.";
  effect.check_reads = CheckReads::number;
  effect.source = "Zhang 2000";
  effect.scope = EffectScope::session;
  effect.parameters = {{"left_fx", "px", 2.5},  {"left_fy", "px", 2.5},  {"left_cx", "px", 4},  {"left_cy", "px", 4},
                       {"right_fx", "px", 2.5}, {"right_fy", "px", 2.5}, {"right_cx", "px", 4}, {"right_cy", "px", 4}};
  effect.move = move;
  return effect;
}

}  // namespace handsight
