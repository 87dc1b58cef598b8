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
  for (const char* camera : {"left_", "right_"}) {
    for (const char* focal : {"fx", "fy"})
      effect.parameters.push_back(
          {.name = std::string(camera) + focal, .unit = "px", .sigma = 2.5, .share_of_focal = 5e-3});
    for (const char* middle : {"cx", "cy"}) effect.parameters.push_back({std::string(camera) + middle, "px", 4});
  }
  effect.move = move;
  return effect;
}

}  // namespace handsight
