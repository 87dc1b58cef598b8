// SPDX-License-Identifier: Apache-2.0
// What images of a board say of a rig's cameras.
#pragma once

#include <Eigen/Core>

#include "camera/rig.h"

namespace handsight {

/// A normal distribution over the numbers of a rig: chi-squared of a rig is
///   residual + 2 pull . y + y' information y,
/// y being its change from `rig` (change_of_rig). `pull` and `residual` come of numbers that stay at what the session
/// has (as k3), where the images have others.
struct CameraKnowledge {
  Rig rig;                      // as the images have it
  Eigen::MatrixXd information;  // by the rig's numbers, of one unit of each; the poses of the board are taken out
  Eigen::VectorXd pull;
  double residual = 0;
  int numbers = 0;  // that the images tell
  int images = 0, points = 0;
  double rms_pixel = 0;  // of the length of a point's residual
};

/// The numbers of a rig against another's with the same cameras, in the layout of camera/rig.h: of motions the small
/// one v in exp(v) camera_from_first, of cameras the differences.
Eigen::VectorXd change_of_rig(const Rig& from, const Rig& to);

/// Chi-squared of a rig.
double disagreement(const CameraKnowledge& knowledge, const Rig& rig);

}  // namespace handsight
