// SPDX-License-Identifier: Apache-2.0
// Grids of circles in an image.
#pragma once

#include "targets/found_target.h"
#include "vision/image/image.h"

namespace handsight {

/// The whole grid or nothing: found by OpenCV, each circle's ellipse fitted, and its centre moved to where the circle's
/// middle is (under tilt and through a lens they differ); a thirtieth of the way is part of the covariance.
TargetSighting detect_circles(const Image& image, const PreparedTarget& target);

}  // namespace handsight
