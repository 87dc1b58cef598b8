// SPDX-License-Identifier: Apache-2.0
// The unknowns that a position can be mistaken for, and what is said of them.
#pragma once

#include <Eigen/Core>
#include <array>

namespace handsight {

/// Of the unknowns of opposite parity to the pattern, which are all that a position can be mistaken for: position
/// (px); shade (1/px); added light (grey levels per px); bends of both edges (1/px).
constexpr int odd_unknown_count = 8;
using OddMatrix = Eigen::Matrix<double, odd_unknown_count, odd_unknown_count>;
using OddVector = Eigen::Matrix<double, odd_unknown_count, 1>;

/// Steps to neighbours over which residuals are compared: right, down, both diagonals, two right, two down.
constexpr int neighbour_count = 6;

/// What the fit's disc says of these unknowns, once for the fit at hand.
struct OddSystem {
  OddMatrix hessian;                                // of half the sum of squares, grey levels^2
  OddVector side;                                   // minus its gradient
  Eigen::Vector2d shade = Eigen::Vector2d::Zero();  // 1/px, that the fit has taken already
  double variance = 0;                              // grey levels^2, of a pixel, by the odd residuals
  double variance_ratio = 1;                        // to that of all residuals
  double weights = 0;                               // pixels that took part
  std::array<double, odd_unknown_count> seen{},
      seen_variance{};                             // of all unknowns, were nothing known of them beforehand
  std::array<float, neighbour_count> influence{};  // how alike the position's dependence on neighbouring pixels is
  std::array<float, neighbour_count> products{};   // of neighbouring residuals, mean over the variance
  double chequer = 0;        // log of how much rougher the pixels of which u + v is even are than the others
  bool is_smoothed = false;  // of the patch without what has a period of 2 px
  Eigen::Matrix2d alias = Eigen::Matrix2d::Zero();  // px^2, of the position then, by what colour filters cannot tell
};

}  // namespace handsight
