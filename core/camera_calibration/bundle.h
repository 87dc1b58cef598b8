// SPDX-License-Identifier: Apache-2.0
// Cameras, their placement and the poses of a target, all at once from where its points were seen.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "camera_calibration/bundle_parts.h"

namespace handsight {

/// The images with the target's shape as it was estimated: what the functions below take poses and residuals with.
BoardImages with_target(const BoardImages& images, const BundleResult& result);

/// The residual of one point: image index, number, px.
struct BundleResidual {
  std::size_t image = 0;
  int number = 0;
  Vector2 pixel, residual;
};
std::vector<BundleResidual> bundle_residuals(const BoardImages& images, const CameraRig& rig,
                                             const std::vector<std::optional<Rigid>>& first_from_target);

/// The least squares from a start; Levenberg-Marquardt of Ceres with our derivatives. Poses of frames without a start
/// are left out.
BundleResult adjust_bundle(const BoardImages& images, const CameraRig& start,
                           const std::vector<std::optional<Rigid>>& first_from_target, const BundleOptions& options,
                           bool with_covariances);

/// The pose of the target in one frame with the rig held: best over both of a plane's poses. Nothing where fewer than
/// four points can be lifted.
std::optional<Rigid> pose_of_frame(const BoardImages& images, const CameraRig& rig, int frame);

/// A rig from nothing but the images. InputError with a sentence where they do not suffice: no image of a camera with
/// enough points, or a camera that shares no frame with the others. `names`: of the cameras.
BundleResult start_bundle(const BoardImages& images, const LensModel& model,
                          const std::vector<std::pair<int, int>>& sizes, const std::vector<std::string>& names);

}  // namespace handsight
