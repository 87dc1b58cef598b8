// SPDX-License-Identifier: Apache-2.0
// Where a target of known shape is, from what one observation saw of it and without any guess.
#pragma once

#include "estimation/problem/body_pose.h"

namespace handsight {

/// A pose, and how much worse the other one is that a flat target looks alike in (times its squared residual; large
/// where there is no other): below 2 the image does not tell which of the two it is.
struct TargetPose {
  BodyPose pose;
  double lead = 1e9;
};

/// Least reprojection error over the sightings of points with the given places (m, by marker). The start is found
/// from points seen by two cameras or measured, else from the camera that saw most: with a flat target by its
/// homography and the tilt mirrored about the line of sight, with another one (tags on a cube) by those of each run of
/// points in a plane. Nothing with fewer than four image points (three
/// measured ones), all on a line, or no pose before the cameras.
std::optional<TargetPose> target_pose(const Rig* rig, const std::vector<Sighting>& sightings,
                                      const std::vector<Vector3>& places);

}  // namespace handsight
