// SPDX-License-Identifier: Apache-2.0
// What a fit's disc says of the unknowns that a position can be mistaken for.
#pragma once

#include <optional>

#include "vision/corners/corner_odd_unknowns.h"
#include "vision/corners/corner_shape.h"
#include "vision/image/image.h"

namespace handsight {

/// Nothing where the fit's disc leaves the image. Without neighbours in a third of the time: the variance is that of
/// the fit, and OddSystem::influence stays 0.
std::optional<OddSystem> odd_system(const Image& image, const CornerFit& fit, bool with_neighbours = true);

/// As if the noise's variance were this many times as large.
void scale_variance(OddSystem& system, double factor);

// What is known of every image beforehand; where a corner tells its own, added light may be wide_added.
constexpr double added_sigma = 0.03;             // grey levels per px: glare over most of an image
constexpr double wide_added = 10 * added_sigma;  // grey levels per px
constexpr double bend_sigma = 3e-4;              // 1/px: a radius of 3000 px
constexpr double most_bend = 0.01;               // 1/px

/// To be added to the hessian's diagonal where that is of noise with this variance (grey levels^2), for the sigmas of
/// added light and bends given.
OddVector usual_information(double variance, double added, double bend);

/// False where the matrix is not positive definite.
bool invert_odd(OddMatrix& matrix);

}  // namespace handsight
