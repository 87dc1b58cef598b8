// SPDX-License-Identifier: Apache-2.0
#include "effects/list.h"
#include "effects/rig_effects.h"

namespace handsight {
Effect lens_distortion(const Rig& rig) {
  Effect effect;
  effect.id = "lens_distortion";
  effect.title = "Lens distortion";
  effect.cause = "The distortion of the lenses is not that of the calibration.";
  effect.visibility = "Needs markers far from the images' middle.";
  effect.check = "Look at a straight edge near the border of the undistorted image.";
  effect.check_reads = CheckReads::image;
  effect.source = "Brown 1971";
  return with_camera_numbers(std::move(effect), rig, camera_number_count - distortion_numbers, distortion_numbers);
}

Effect lens_distortion() { return lens_distortion(make_rig(StereoRig{})); }

}  // namespace handsight
