// SPDX-License-Identifier: Apache-2.0
// What views that nothing was fitted to say of a model of lens and target, and which of several models they prefer.
#pragma once

#include <optional>
#include <vector>

#include "camera/lens.h"
#include "camera_calibration/bundle_parts.h"

namespace handsight {

/// Root of the mean squared length of a point's residual, px, of frames that the cameras' numbers were not fitted to:
/// each frame's pose is then fitted to all its images with the cameras held.
struct HeldOut {
  double rms_pixel = 0;
  std::vector<std::optional<double>> frames;  // by frame; nothing where it has no pose
};

/// The error of one frame as HeldOut says it, by any rig; nothing where it has no pose.
std::optional<double> frame_rms(const BoardImages& images, const CameraRig& rig, int frame);

/// Robust least squares from a solution, with as much of the target's shape as it has: beyond four sigmas of their
/// scatter residuals count linearly.
BundleResult adjust_robustly(const BoardImages& images, const BundleResult& start, bool with_covariances);

/// Each frame's error by the cameras and the target's shape from the others (in 10 to 15 parts), the poses its own.
HeldOut held_out(const BoardImages& images, const BundleResult& whole);

/// A model that was fitted.
struct FittedModel {
  BundleResult bundle;
  HeldOut held_out;

  const LensModel& lens() const { return *bundle.rig.lenses[0].model; }
  /// Its numbers are determined and it has errors of views that were held out.
  bool is_known() const { return held_out.rms_pixel > 0 && bundle.lens_covariances.at(0).has_value(); }
};

/// Do the held-out views say beyond doubt that `other` is nearer to the truth: 3 % less error, and so from view to view
/// that chance would do it once in a thousand?
bool is_beyond_doubt(const FittedModel& simple, const FittedModel& other);

/// The simplest of those that no other one excels beyond doubt: the plain lens before others, a target as described
/// before a bent one and that before one of free points. Null where there is none.
const FittedModel* preferred(const std::vector<FittedModel>& candidates);

/// What the target's shape may be, the usual first: as described, bent, or of free points; within its sigma, or free.
std::vector<BoardShape> list_shapes(const BoardImages& images);

/// The candidate with another shape of the target; itself where its least squares do not come to an end.
FittedModel reshaped(const BoardImages& images, const FittedModel& from, BoardShape shape);

}  // namespace handsight
