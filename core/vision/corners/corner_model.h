// SPDX-License-Identifier: Apache-2.0
// The image of an X-corner as a formula, and its least-squares fit: the symmetry of thesis (4.4) uses only that the
// patch is even, this uses its whole shape and comes near the Cramer-Rao bound.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "vision/corners/corner_shape.h"
#include "vision/corners/corner_structure.h"
#include "vision/image/image.h"

namespace handsight {

/// The same image, told from where the corner lies: on this side of the shadow's edge.
CornerModel told_from_corner(const CornerModel& model);

/// The shadow's factor at x (px from the corner), 1 at the corner where the shadow's edge is far enough.
double light_at(const ShadowEdge& shadow, const Eigen::Vector2d& from_corner);

/// The same shadow's edge as seen from a point that lies `off` px from the corner; its distance is negative where the
/// point lies beyond it.
ShadowEdge seen_from(const ShadowEdge& shadow, const Eigen::Vector2d& off);

/// What the circles showed, as a model to start from.
CornerModel first_guess(const Eigen::Vector2d& start, const CrossStructure& cross);

/// Gauss-Newton from a start that is good to about 1 px. The disc grows from 4 px as long as the formula holds, so
/// that it ends before the next cell or what lies beside the marker. Nothing where the fit runs away, the disc of
/// 4 px leaves the image, or what comes out is no X: edges nearly parallel, more blur than plateau, half contrasts
/// that the image does not reach, residuals that `image_noise` (grey levels, sigma of a pixel) does not explain, a
/// position that is not determined.
std::optional<CornerFit> fit_corner(const Image& image, const Eigen::Vector2d& start, const CrossStructure& cross,
                                    double image_noise);

/// The same on a disc of 3 px, which grows by some px at most: for corners of which the next ones are near. The start
/// must be as good as a neighbour on the board tells it.
std::optional<CornerFit> fit_small_corner(const Image& image, const Eigen::Vector2d& start, const CrossStructure& cross,
                                          double image_noise);

/// The same for a corner beside a shadow's edge, which is looked for in what `first` leaves within 9 px; from a start
/// that is good to 1.8 px. Nothing where no line splits the patch into two of different light, or where it would run
/// through the corner.
std::optional<CornerFit> fit_beside_shadow(const Image& image, const Eigen::Vector2d& start,
                                           const CrossStructure& cross, const CornerModel& first, Guess guess,
                                           double image_noise);

/// The same from what a board and other corners beside the same shadow tell of both: however near its edge is. Nothing
/// where the fit leads far from that.
std::optional<CornerFit> fit_in_known_shadow(const Image& image, const CornerModel& expected, double image_noise);

/// The same where only the board tells of the corner and the shadow's edge is looked for in what `expected`, which has
/// none, leaves within 9 px.
std::optional<CornerFit> fit_in_unknown_shadow(const Image& image, const CornerModel& expected, double image_noise);

}  // namespace handsight
