// SPDX-License-Identifier: Apache-2.0
// A shadow's edge beside a corner: where it may be, and the fit of corner and shadow together.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "vision/corners/corner_patch.h"
#include "vision/image/image.h"

namespace handsight {

constexpr double penumbra_px = 0.6;                       // px, of a usual shadow's edge before the lens
constexpr double most_depth = 0.9, most_lit_beyond = -4;  // of shadows

/// The straight line that best splits the pixels of the patch into two of different light, by what `evaluate` left of a
/// model without a shadow; pixels at the model's own edges count little. Nothing where the two lights tell less than
/// a third of what the one leaves, or no more than noise of sigma `noise` grey levels would; nor where a model that was
/// only guessed leaves more than a corner beside a shadow does.
std::optional<ShadowEdge> likely_shadow(const CornerPatch& patch, const CornerModel& model, Guess guess, double noise);

/// Where corner and shadow's edge lie tells of which four patterns the pixels of a disc are made: the light on this
/// side, the cells, and both beyond. Grey levels and the shadow's depth follow from their shares, whatever `expected`
/// says of them, which is returned as it is where the shares are of no shadow.
CornerModel lit_as_seen(const Image& image, const CornerModel& expected, double radius, CornerPatch& patch);

struct ShadowFit {
  CornerModel model;
  double noise = 0;  // grey levels, sigma of a pixel
};

/// When a fit is given up: residuals beyond what the image's noise explains, in half contrasts.
struct Patience {
  int steps = 5;
  double most_at_first = 1, most_on_the_way = 1;
  Sharing sharing = Sharing::all;
};

/// Levenberg-Marquardt over all thirteen numbers of `start`, on the disc of `radius` px. Nothing where the disc leaves
/// the image, where the fit fails, runs away or leaves more than `patience` allows. `image_noise`: grey levels, sigma
/// of a pixel. The patch holds the last step's pixels and derivatives.
std::optional<ShadowFit> fit_with_shadow(const Image& image, const CornerModel& start, double radius,
                                         const Patience& patience, double image_noise, CornerPatch& patch);

/// px^2, of the position, with everything else unknown. Spoils the patch's derivatives.
Eigen::Matrix2d position_covariance_with_shadow(double noise, const CornerModel& model, CornerPatch& patch);

}  // namespace handsight
