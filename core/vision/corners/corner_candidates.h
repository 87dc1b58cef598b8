// SPDX-License-Identifier: Apache-2.0
// Where an X-corner may be: saddle points of the smoothed image. A cheap test of every pixel, so that the symmetry
// of thesis (4.4) need be worked out at few.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "vision/corners/corner_structure.h"
#include "vision/image/image.h"

namespace handsight {

struct CornerCandidate {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  // px, of the saddle point, good to about a pixel
  float saddle = 0;              // minus the Hessian's determinant, (grey levels per px^2)^2 of the smoothed image
  bool stationary = true;        // the smoothed grey levels' gradient vanishes within 3 px
  std::optional<Lighting> ring;  // what the ring of pixels round it may be of (may_be_cross); nothing: no cross
};

/// Saddle points of the image smoothed by a Gaussian of about 2 px: Ixx Iyy - Ixy^2 < 0 has a local minimum there
/// that is deep enough for an X-corner of `min_contrast` grey levels under a blur of 2.5 px, and deeper than white
/// noise of sigma `noise` grey levels makes them. Row by row; of each tile of 128 x 128 px the strongest 400 at most.
/// `half`, if given, becomes the image at half the resolution: the rounded mean of 2 x 2 pixels; one of that size
/// already is written over, which spares a large image's memory being asked for again.
std::vector<CornerCandidate> saddle_candidates(const Image& image, double min_contrast, double noise,
                                               Image* half = nullptr);

/// Work on smaller images is done before other threads have begun.
inline bool is_worth_threads(const Image& image) { return static_cast<double>(image.width) * image.height > 1.5e6; }

}  // namespace handsight
