// SPDX-License-Identifier: Apache-2.0
#include "effects/list.h"
#include "effects/rig_effects.h"

namespace handsight {
Effect camera_intrinsics(const Rig& rig) {
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
  return with_camera_numbers(std::move(effect), rig, 0, camera_number_count - distortion_numbers);
}

Effect camera_intrinsics() { return camera_intrinsics(make_rig(StereoRig{})); }

}  // namespace handsight
