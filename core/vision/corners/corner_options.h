// SPDX-License-Identifier: Apache-2.0
// What an X-corner is when it is found, and what one may ask of the detector.
#pragma once

#include <Eigen/Core>
#include <array>

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

}  // namespace handsight
