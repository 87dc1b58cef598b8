// SPDX-License-Identifier: Apache-2.0
// What images of a board say of cameras that have numbers already.
#pragma once

#include "camera/camera_knowledge.h"
#include "camera_calibration/board_images.h"

namespace handsight {

/// The images grouped by the cameras of a rig: by their names where all of them are found, else in their order. A
/// sentence in the notes where it was the order. InputError where there are more or fewer.
GroupedImages group_by_cameras(const GroupedImages& grouped, const Rig& rig);

/// Adjusts all cameras, their placement and the poses of the target to the images from what the rig has, robustly, and
/// takes the poses out. InputError where the images have another size than the camera's, where nothing was found, where
/// the images do not determine the cameras' numbers, or a camera has a skew, which no lens model has.
CameraKnowledge board_knowledge(const DetectedImages& images, const Rig& rig);

}  // namespace handsight
