// SPDX-License-Identifier: Apache-2.0
// Is it an X? Two black and two white sectors alternate round an X-corner; round a dot, a line, an L-corner or a
// T-junction, which may be point symmetric too or lie on a saddle, they do not.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "vision/image/image.h"

namespace handsight {

/// I = level + half_contrast sgn(d1) sgn(d2), where d_i is the signed distance to edge i through the centre,
/// d = -sin(edge) (u - u0) + cos(edge) (v - v0).
struct CrossStructure {
  std::array<double, 2> edges{};  // rad, each in [0, pi), the first one smaller
  double level = 0;               // grey levels
  double half_contrast = 0;       // grey levels, negative where the sector between the edges' angles is white
  double asymmetry = 0;           // root of the mean square half difference of opposite points, in contrasts
  double blur = 1;                // px, sigma, a guess from how much the contrast grows from 2.5 to 4 px
  static constexpr int direction_count = 16;   // on half a circle
  std::array<float, direction_count> profile;  // grey levels, mean of opposite points of the circles
};

/// What the light may be where there is a corner: a shadow's edge near it makes opposite sectors differ.
enum class Lighting { even, shadowed };

/// The cheapest test: 16 pixels on a circle of 3 px. Nothing where points a quarter turn apart differ by too little for
/// a corner of `min_contrast` grey levels, or less than 0.6 times as opposite ones, beyond what noise of sigma `noise`
/// grey levels makes; 1.5 times is what even light takes. The pixel must be 3 px inside the image.
std::optional<Lighting> may_be_cross(const Image& image, const Eigen::Vector2i& pixel, double min_contrast,
                                     double noise);

/// Reads circles round `centre` (px) and finds the four sectors; nothing where they do not alternate, where opposite
/// ones differ more than neighbours, or where the circles leave the image.
std::optional<CrossStructure> cross_structure(const Image& image, const Eigen::Vector2d& centre, double min_contrast,
                                              Lighting light = Lighting::even);

/// What four blurred sectors of two grey levels leave of the profile, whatever their blur: half contrasts, root mean
/// square. Where some blur leaves no more than `enough` another may leave less yet.
double sector_misfit(const CrossStructure& cross, double enough = 0);

}  // namespace handsight
