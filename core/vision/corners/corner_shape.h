// SPDX-License-Identifier: Apache-2.0
// What an X-corner in an image is described by: the numbers of its formula, and what a fit of them gives.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

namespace handsight {

/// The straight edge of a shadow: light(x) = 1 - depth (1 + erf((n . x - distance) / (sqrt2 softness))) / 2, with
/// n = (cos direction, sin direction). The light at the corner is what the others are described by, so that the depth
/// is negative where the corner lies in the shadow.
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

struct CornerFit {
  CornerModel model;
  Eigen::Matrix2d covariance;  // px^2, of the position
  double radius = 0;           // px, of the disc of pixels that took part
  double noise = 0;            // grey levels, sigma of a pixel
  double misfit = 0;  // grey levels, root of the mean product of neighbouring residuals over 4 px: the shape's part
  bool is_clipped = false;  // some pixels may be as bright or as dark as the sensor tells
};

/// Where a first model is from: of a fit, or of the circles alone, where most are no corners.
enum class Guess { fitted, from_circles };

}  // namespace handsight
