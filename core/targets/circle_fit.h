// SPDX-License-Identifier: Apache-2.0
// The ellipse that a circle is in an image, from the tangents that its edge's pixels tell.
#pragma once

#include <optional>
#include <vector>

#include "geometry/rigid.h"
#include "vision/image/image.h"

namespace handsight {

/// A straight line that touches the ellipse: through `point` (px) across `normal` (unit), counted `weight` times.
struct Tangent {
  Vector2 point = Vector2::Zero(), normal = Vector2::Zero();
  double weight = 1;
};

struct FittedEllipse {
  Vector2 centre = Vector2::Zero();                      // px
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  // px^2, of the centre; zero where lines tell no noise
  Eigen::Matrix2d shape = Eigen::Matrix2d::Zero();       // px^2: (x - centre)' shape^-1 (x - centre) = 1
};

/// The dual conic with the least weighted distances to the lines (Ouellet and Hebert 2009); `about` and `size` (px) are
/// roughly its centre and radius. Nothing where the lines make no ellipse.
std::optional<FittedEllipse> fit_ellipse(const std::vector<Tangent>& tangents, const Vector2& about, double size);

/// The ellipse of a dark disc, by the grey levels' gradients in a ring about one that is roughly known. `noise`: grey
/// levels, from which the covariance follows.
std::optional<FittedEllipse> ellipse_in(const Image& image, const Vector2& centre, const Eigen::Matrix2d& shape,
                                        double noise);

}  // namespace handsight
