// SPDX-License-Identifier: Apache-2.0
// The first observation: the user points at the markers in the left image, the program finds their partners in the
// right one (thesis 4.3.1).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/message.h"
#include "vision/markers/corner_pairs.h"

namespace handsight {

struct LabelOptions {
  PairOptions pairs;
  double snap_distance = 12.0;   // px: how far the nearest corner may be from where the user pointed
  double smallest_side = 0.015;  // m: shorter triangles do not fix the body's rotation well
  double line_sine = 0.10;       // the triangle's smallest height over its longest side; less counts as a line
  double most_spread = 0.5;      // m: markers of one hand are no farther apart
};

struct LabelledMarker {
  Vector2 left, right;                                // px, the corners
  Eigen::Matrix2d left_covariance, right_covariance;  // px^2, PairOptions::corner_floor included
  StereoPoint point;
  int other_candidates = 0;  // right corners that would do as well by the epipolar line alone
};

struct FirstLabels {
  std::vector<LabelledMarker> markers;  // in the order in which the user pointed; empty where it will not do
  Message refusal;                      // a sentence: what, where, what to do; empty where it will do
};

/// Snaps every pointed position (px, left image) to its nearest corner, finds the right corners by the epipolar
/// line, and of all combinations takes the one whose corners are nearest to their lines, look alike, and stay
/// together. One marker has no triangle to be judged, two only their distance.
FirstLabels label_first(const StereoRig& rig, const std::vector<Corner>& left, const std::vector<Corner>& right,
                        const std::vector<Vector2>& pointed, const LabelOptions& options = {});

}  // namespace handsight
