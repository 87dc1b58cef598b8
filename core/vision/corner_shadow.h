// SPDX-License-Identifier: Apache-2.0
// A shadow's edge beside a corner: where it may be, and the fit of corner and shadow together.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "vision/corner_model.h"
#include "vision/corner_patch.h"
#include "vision/image.h"

namespace handsight {

/// The straight line that best splits the pixels of the patch into two of different light, by what `evaluate` left of a
/// model without a shadow; pixels at the model's own edges count little. Nothing where the two lights tell less than
/// a third of what the one leaves, or no more than noise of sigma `noise` grey levels would.
std::optional<ShadowEdge> likely_shadow(const CornerPatch& patch, const CornerModel& model, double noise);

struct ShadowFit {
  CornerModel model;
  double noise = 0;  // grey levels, sigma of a pixel
};

/// Levenberg-Marquardt over all thirteen numbers of `start`, on the disc of `radius` px. Nothing where the disc leaves
/// the image, where the fit fails or runs away. The patch holds the last step's pixels and derivatives.
std::optional<ShadowFit> fit_with_shadow(const Image& image, const CornerModel& start, double radius, int iterations,
                                         CornerPatch& patch);

/// px^2, of the position, with everything else unknown. Spoils the patch's derivatives.
Eigen::Matrix2d position_covariance_with_shadow(double noise, const CornerModel& model, CornerPatch& patch);

}  // namespace handsight
