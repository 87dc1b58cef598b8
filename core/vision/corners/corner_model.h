// SPDX-License-Identifier: Apache-2.0
// The image of an X-corner as a formula, and its least-squares fit: the symmetry of thesis (4.4) uses only that the
// patch is even, this uses its whole shape and comes near the Cramer-Rao bound.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "vision/corners/corner_structure.h"
#include "vision/image/image.h"

namespace handsight {

/// The straight edge of a shadow: light(x) = 1 - depth (1 + erf((n . x - distance) / (sqrt2 softness))) / 2, with
/// n = (cos direction, sin direction). The light at the corner is what the others are told by, so that the depth is
/// negative where the corner lies in the shadow.
struct ShadowEdge {
  double direction = 0;   // rad, from the corner to the edge
  double distance = 0;    // px, of the edge from the corner
  double depth = 0;       // by how much less light there is beyond; 0: there is no shadow's edge
  double softness = 1.5;  // px, sigma, of the shadow's edge and the lens together
};

/// I(u, v) = light(x) (1 + shade . x) (level + half_contrast X(d1, d2)), with x = (u, v) - position and
/// d_i = -sin(edge_i) x + cos(edge_i) y: two straight edges through one point, sgn(d1) sgn(d2), blurred together
/// (corner_crossing.h), under light that changes evenly, or at a shadow's edge. Perspective keeps edges straight and
/// through one point, so it needs no more.
struct CornerModel {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  // px
  std::array<double, 2> edges{};                       // rad
  double blur = 1.0;                                   // px, sigma, of lens and pixel together
  double level = 0;                                    // grey levels
  double half_contrast = 0;                            // grey levels, signed as in CrossStructure
  Eigen::Vector2d shade = Eigen::Vector2d::Zero();     // 1/px
  ShadowEdge shadow;
};

inline bool has_shadow(const CornerModel& model) { return model.shadow.depth != 0; }

/// Grey levels, where more light falls.
inline double half_contrast_in_light(const CornerModel& model) {
  return std::abs(model.half_contrast) * std::max(1.0, 1 - model.shadow.depth);
}

/// The same image, told from where the corner lies: on this side of the shadow's edge.
CornerModel told_from_corner(const CornerModel& model);

/// The shadow's factor at x (px from the corner), 1 at the corner where the shadow's edge is far enough.
double light_at(const ShadowEdge& shadow, const Eigen::Vector2d& from_corner);

/// The same shadow's edge as seen from a point that lies `off` px from the corner; its distance is negative where the
/// point lies beyond it.
ShadowEdge seen_from(const ShadowEdge& shadow, const Eigen::Vector2d& off);

/// What the circles showed, as a model to start from.
CornerModel first_guess(const Eigen::Vector2d& start, const CrossStructure& cross);

struct CornerFit {
  CornerModel model;
  Eigen::Matrix2d covariance;  // px^2, of the position
  double radius = 0;           // px, of the disc of pixels that took part
  double noise = 0;            // grey levels, sigma of a pixel
  double misfit = 0;  // grey levels, root of the mean product of neighbouring residuals over 4 px: the shape's part
  bool is_clipped = false;  // some pixels may be as bright or as dark as the sensor tells
};

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

/// Where a first model is from: of a fit, or of the circles alone, where most are no corners.
enum class Guess { fitted, from_circles };

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
