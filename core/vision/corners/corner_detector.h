// SPDX-License-Identifier: Apache-2.0
// X-corners by point symmetry (thesis section 4.1.1), finished by a fit of the blurred X (corner_model.h), which lies
// nearer to the Cramer-Rao bound and gives the covariance.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "vision/corners/corner_options.h"
#include "vision/image/image.h"

namespace handsight {

/// All X-corners of the image, strongest first. Corners nearer to the border than the window are left out; of what is
/// so blurred that it is found in the halved or quartered image those nearer than twice or four times that, but for
/// what a board predicts.
std::vector<Corner> detect_corners(const Image& image, const DetectorOptions& options = {});

/// Gauss-Newton to the point of best symmetry from `start` (px), then the fit; nothing where it leads farther than
/// 1.5 sigma away or is no X-corner.
std::optional<Corner> refine_corner(const Image& image, const Eigen::Vector2d& start,
                                    const DetectorOptions& options = {});

}  // namespace handsight
