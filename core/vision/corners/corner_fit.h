// SPDX-License-Identifier: Apache-2.0
// What all fits of corners share: how far a disc holds, and whether what comes out may be a corner.
#pragma once

#include "vision/corners/corner_patch.h"
#include "vision/corners/corner_shape.h"

namespace handsight {

constexpr double most_move = 1.8;     // px, from the start
constexpr double most_misfit = 0.21;  // half contrasts; sharpening in the camera leaves less
constexpr double most_blur = 0.6;     // radii: a saddle that never becomes flat is no corner

/// How far the model holds, px, `most` at most: ring by ring from `radius` on, as long as the residuals stay what they
/// are inside, where they leave `noise` (grey levels).
double grown_radius(const Image& image, double radius, int most, double noise, const CornerModel& model,
                    CornerPatch& patch);

/// Root of the mean product of neighbouring residuals: of white noise nothing remains, of a wrong shape most does.
double compute_misfit(const CornerPatch& patch);

/// Bounds beyond what X-corners of 8 px cells show at 60 deg and 2.5 px of blur, `half_contrast` by their circles. Over
/// the first disc blur and contrast are hard to tell from each other, so there they are `loose`.
bool looks_right(const CornerModel& model, double half_contrast, double noise, double image_noise, double loose);

/// Edges nearly along each other leave the position open; what rounding makes of its covariance then is none.
inline bool is_determined(const CornerFit& fit) { return fit.covariance(0, 0) > 0 && fit.covariance.determinant() > 0; }

}  // namespace handsight
