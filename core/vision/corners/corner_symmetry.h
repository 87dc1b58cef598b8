// SPDX-License-Identifier: Apache-2.0
// The point of best symmetry (thesis section 4.1.1).
#pragma once

#include <Eigen/Core>
#include <optional>

#include "vision/corners/corner_shape.h"
#include "vision/image/image.h"

namespace handsight {

struct SymmetryPoint {
  Eigen::Vector2d position;    // px
  Eigen::Matrix2d covariance;  // px^2
  double strength = 0;         // smaller eigenvalue of the Gauss-Newton Hessian of O, thesis (4.11), grey levels^2/px^2
  double noise = 0;            // grey levels, sigma of a pixel by the antisymmetric part that is left
};

/// Gauss-Newton on O(x) = sum_y G(y, sigma) (I(x+y) - I(x-y))^2, thesis (4.4), with J = grad I(x+y) - grad I(x-y),
/// thesis (4.7), from `start`. Nothing where the window leaves the image, the Hessian is singular, or the point is
/// farther than `reach` px from the start.
/// Covariance: G is not the inverse covariance of the differences, so it is H^-1 (sum G^2 J J^T var) H^-1 with var
/// the G-weighted mean square difference at the solution. After `iterations` steps one more is taken on trust: what it
/// leaves is foreseen from the derivatives, not looked at.
/// With `lit` the image is taken as it would be without that model's shadow, what was dark weighing less.
std::optional<SymmetryPoint> symmetry_point(const Image& image, const Eigen::Vector2d& start, double sigma,
                                            double reach, int iterations = 4, const CornerModel* lit = nullptr);

}  // namespace handsight
