// SPDX-License-Identifier: Apache-2.0
// Intrinsics and placement of cameras from images of a target: which lens model, how sure, and where it does not fit.
#pragma once

#include <string>
#include <vector>

#include "base/message.h"
#include "camera_calibration/held_out.h"

namespace handsight {

struct CalibrationOptions {
  /// A lens model's name, or "best": the plain lens (brown), unless views that were held out say beyond doubt that it
  /// is another one.
  std::string model = "best";
};

/// A lens model, with what is chosen of the target's shape.
struct TriedModel {
  std::string name;
  double rms_pixel = 0, held_out_rms_pixel = 0;
  Message failure;  // why it has none; empty: it has
};

/// What the target's shape may be, with the chosen lens.
struct TriedShape {
  BoardShape shape = BoardShape::held;
  double rms_pixel = 0, held_out_rms_pixel = 0;
  Vector3 bend = Vector3::Zero();      // 1/m; of BoardShape::bent
  std::optional<Vector3> bend_sigmas;  // 1/m
};

/// Residuals over one camera's image, in 8 x 6 equal cells, row by row.
struct ResidualCell {
  int points = 0;
  Vector2 mean = Vector2::Zero();  // px
  double rms_pixel = 0;
};
struct CameraReport {
  double rms_pixel = 0;
  int images = 0, points = 0;
  std::vector<ResidualCell> cells;
  static constexpr int columns = 8, rows = 6;
};

struct CameraCalibration {
  BundleResult bundle;
  HeldOut held_out;
  std::vector<TriedModel> tried;
  std::vector<TriedShape> shapes;  // that were tried with the chosen lens
  std::vector<CameraReport> cameras;
  std::vector<Message> warnings;  // sentences: where the images do not suffice
};

/// `sizes` (px) and `names` of the cameras. The target is as described (within BoardImages::sigma), unless views that
/// were held out say beyond doubt that it is bent or otherwise not so. InputError where the images do not suffice at
/// all.
CameraCalibration calibrate_cameras(const BoardImages& images, const std::vector<std::pair<int, int>>& sizes,
                                    const std::vector<std::string>& names, const CalibrationOptions& options = {});

/// The rig as OpenCV's FileStorage (YAML): M1 D1 (and M2 D2 ...), R T of X_2 = R X_1 + T (R_3 T_3 ...), image_width,
/// image_height, camera names and models; one camera alone also as camera_matrix and distortion_coefficients.
std::string rig_yaml(const CameraRig& rig, const std::vector<std::string>& names);

}  // namespace handsight
