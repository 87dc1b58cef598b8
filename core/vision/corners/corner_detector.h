// SPDX-License-Identifier: Apache-2.0
// X-corners by point symmetry (thesis section 4.1.1), finished by a fit of the blurred X (corner_model.h), which lies
// nearer to the Cramer-Rao bound and gives the covariance.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "vision/image/image.h"

namespace handsight {

/// One X-corner: where two black and two white sectors meet.
struct Corner {
  Eigen::Vector2d position;       // px, centre of the top left pixel is (0, 0)
  Eigen::Matrix2d covariance;     // px^2, of `position`, estimated from the image itself
  double strength = 0;            // smaller eigenvalue of the symmetry objective's Hessian, comparable in one image
  double contrast = 0;            // grey levels between the white and the black sectors
  std::array<double, 2> edges{};  // rad, directions of the two edges through the corner, each in [0, pi)
};

struct DetectorOptions {
  double sigma = 2.0;          // px, of the Gaussian window G of thesis (4.3)
  double min_contrast = 20.0;  // grey levels
  int max_corners = 2000;      // the strongest are kept
};

/// All X-corners of the image, strongest first. Corners nearer to the border than the window are left out; of what is
/// so blurred that it is found in the halved or quartered image those nearer than twice or four times that, but for
/// what a board foretells.
std::vector<Corner> detect_corners(const Image& image, const DetectorOptions& options = {});

/// Gauss-Newton to the point of best symmetry from `start` (px), then the fit; nothing where it leads farther than
/// 1.5 sigma away or is no X-corner.
std::optional<Corner> refine_corner(const Image& image, const Eigen::Vector2d& start,
                                    const DetectorOptions& options = {});

}  // namespace handsight
