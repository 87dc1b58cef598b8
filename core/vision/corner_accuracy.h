// SPDX-License-Identifier: Apache-2.0
// How well a fitted position is known, and the last small step to it: with unknowns that hardly any corner needs but
// some images have (light that is added, edges that the lens bends), and with noise that is not white.
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>

#include "vision/corner_model.h"

namespace handsight {

/// Of the unknowns of opposite parity to the pattern, which are all that a position can be mistaken for: position
/// (px); shade (1/px); added light (grey levels per px); bends of both edges (1/px).
constexpr int kOddUnknowns = 8;
/// Steps to neighbours over which residuals are compared: right, down, both diagonals, two right, two down.
constexpr int kNeighbours = 6;

/// What the fit's disc says of these unknowns, once for the fit at hand.
struct OddSystem {
  Eigen::Matrix<double, kOddUnknowns, kOddUnknowns> hessian;  // of half the sum of squares, grey levels^2
  Eigen::Matrix<double, kOddUnknowns, 1> side;                // minus its gradient
  Eigen::Vector2d shade = Eigen::Vector2d::Zero();            // 1/px, that the fit has taken already
  double variance = 0;                                        // grey levels^2, of a pixel, by the odd residuals
  double variance_ratio = 1;                                  // to that of all residuals
  double weights = 0;                                         // pixels that took part
  std::array<double, kOddUnknowns> seen{}, seen_variance{};   // of all unknowns, were nothing known of them beforehand
  std::array<float, kNeighbours> influence{};  // how alike the position's dependence on neighbouring pixels is
  std::array<float, kNeighbours> products{};   // of neighbouring residuals, mean over the variance
  double chequer = 0;        // log of how much rougher the pixels of which u + v is even are than the others
  bool is_smoothed = false;  // of the patch without what has a period of 2 px
  Eigen::Matrix2d alias = Eigen::Matrix2d::Zero();  // px^2, of the position then, by what colour filters cannot tell
};

/// The same of the patch smoothed by 1 4 6 4 1 across and down: interpolated colours have errors of the pattern's own
/// period, 2 px, which are none any more. The variance is that of noise that changes as slowly as what a position shows
/// in.
std::optional<OddSystem> smoothed_odd_system(const Image& image, const CornerFit& fit);

/// Nothing where the fit's disc leaves the image. Without neighbours in a third of the time: the variance is that of
/// the fit, and OddSystem::influence stays 0.
std::optional<OddSystem> odd_system(const Image& image, const CornerFit& fit, bool with_neighbours = true);

/// As if the noise's variance were this many times as large.
void scale_variance(OddSystem& system, double factor);

/// A few pixels tell their noise badly: how many times as large the variance is that so many pixels (`weights`) tell,
/// once it is weighed against what the image's corners tell together.
double pooling(double variance, double weights, double of_image);

/// What the corners of one image have in common.
struct Habits {
  double variance = 1;                            // of the odd residuals over that of the fit's
  double bend = 3e-4;                             // 1/px, sigma of the edges' bends
  std::array<double, kNeighbours> correlation{};  // of the noise of neighbouring pixels
  double added = 0.03;                            // grey levels per px, sigma of added light
  bool is_mosaic = false;                         // colours were interpolated
  std::array<float, kNeighbours> influence{};     // the mean of OddSystem::influence, for those that have none
};
Habits habits_of(std::span<const OddSystem> systems);
/// Whether the lens plainly bends edges.
bool are_bent(const Habits& habits);

/// Whether glare plainly adds light.
bool are_glared(const Habits& habits);

/// Whether light is plainly added, or an edge plainly bent.
bool is_plain(const OddSystem& system);

struct LastStep {
  bool is_needed = false;                          // by this corner or by all together: otherwise the move is chance
  Eigen::Vector2d move = Eigen::Vector2d::Zero();  // px
  Eigen::Matrix2d covariance;                      // px^2
};
/// Nothing where the system is singular.
std::optional<LastStep> last_step(const OddSystem& system, const Habits& habits);

/// By how much correlated noise enlarges a covariance.
double correlation_factor(const OddSystem& system, const Habits& habits);

}  // namespace handsight
