// SPDX-License-Identifier: Apache-2.0
// What a bundle is adjusted to, what may be estimated, and what comes out.
#pragma once

#include <optional>
#include <vector>

#include "camera/lens.h"
#include "targets/found_target.h"

namespace handsight {

/// The points of one image. Images of the same frame were taken at once.
struct BoardImage {
  int camera = 0, frame = 0;
  std::vector<TargetPixel> points;
};

/// What the images were taken of and with.
struct BoardImages {
  std::vector<Vector3> points;  // m, of the target, by number, as it is described
  int camera_count = 0, frame_count = 0;
  std::vector<BoardImage> images;
  std::vector<int> pieces = {};     // of each point: those of a piece are one body; empty: all are
  std::optional<double> sigma = 0;  // m, how exactly the print is known (Target::sigma)
};

/// What of the target's shape is estimated with the cameras: nothing; how it is bent; every point, known within
/// BoardImages::sigma; every point anywhere. How large it is images alone cannot tell: of free points the size of the
/// whole is as described.
enum class BoardShape { held, bent, within, free };

/// Cameras and where the first has the others: X_c = from_first[c] X_first; from_first[0] is the identity.
struct CameraRig {
  std::vector<Lens> lenses;
  std::vector<Rigid> from_first;
};

struct BundleOptions {
  double loss_pixel = 0;  // px: residuals (of a point) beyond it count linearly (Huber); 0: all count squared
  int most_steps = 100;
  BoardShape shape = BoardShape::held;
  double pixel_sigma = 0.1;                 // px, of one coordinate: what the target's sigma is weighed against
  Vector3 bend = Vector3::Zero();           // 1/m, to start from
  std::vector<Vector3> target_points = {};  // m, by number, to start from; empty: as described
};

struct BundleResult {
  CameraRig rig;
  std::vector<std::optional<Rigid>> first_from_target;  // by frame; nothing where no camera saw it
  double rms_pixel = 0;                                 // root of the mean squared length of a point's residual
  int points = 0;
  bool converged = false;
  BoardShape shape = BoardShape::held;
  std::vector<Vector3> target_points;      // m, by number, with the shape as it was estimated
  Vector3 bend = Vector3::Zero();          // 1/m: along x, along y, and askew; of BoardShape::bent
  std::optional<Matrix3> bend_covariance;  // nothing unless it was estimated and is determined
  /// Of the numbers of camera c, and of the small motion in exp(v) from_first[c]; nothing where the images do not
  /// determine them. From the scatter of the residuals.
  std::vector<std::optional<Eigen::MatrixXd>> lens_covariances;
  std::vector<std::optional<Matrix6>> placement_covariances;
  /// Of all of them at once: every camera's numbers, then the small motions of all cameras but the first.
  std::optional<Eigen::MatrixXd> covariance;
};

}  // namespace handsight
