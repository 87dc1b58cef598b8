// SPDX-License-Identifier: Apache-2.0
// Corners of both images that may be the same point: the epipolar pairs (thesis 4.3.1, 4.3.2).
#pragma once

#include <vector>

#include "camera/camera.h"
#include "vision/corners/corner_options.h"

namespace handsight {

struct PairOptions {
  double epipolar_threshold = 2.0;  // px, (4.50) as a distance; 3 sigma of the two corners are added
  double corner_floor = 0.1;        // px: added to every corner's sigma, for what the cameras' calibration leaves
  double nearest = 0.05;            // m, depth of the point in front of the left camera
  double farthest = 20.0;           // m
};

/// A left and a right corner that satisfy the epipolar constraint, triangulated.
struct CornerPair {
  int left = 0;  // indices into the corners
  int right = 0;
  StereoPoint point;
  double unlikeness = 0;  // 0 alike to 1 unlike: edge directions and contrast of the two corners
};

/// How sure a corner is as a measurement (px^2): as seen in the image, and what the cameras' calibration leaves.
Eigen::Matrix2d measured_covariance(const Corner& corner, const PairOptions& options = {});

/// All pairs of the left corners (those of `lefts`, or all where it is empty) with right corners. Ordered by left
/// corner, then by epipolar distance.
std::vector<CornerPair> corner_pairs(const StereoRig& rig, const std::vector<Corner>& left,
                                     const std::vector<Corner>& right, const PairOptions& options = {},
                                     const std::vector<int>& lefts = {});

}  // namespace handsight
