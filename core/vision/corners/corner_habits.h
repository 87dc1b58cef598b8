// SPDX-License-Identifier: Apache-2.0
// What the corners of one image have in common: their noise, what the lens bends, glare, interpolated colours.
#pragma once

#include <array>
#include <span>

#include "vision/corners/corner_odd_unknowns.h"

namespace handsight {

struct Habits {
  double variance = 1;                                // of the odd residuals over that of the fit's
  double bend = 3e-4;                                 // 1/px, sigma of the edges' bends
  std::array<double, neighbour_count> correlation{};  // of the noise of neighbouring pixels
  double added = 0.03;                                // grey levels per px, sigma of added light
  bool is_mosaic = false;                             // colours were interpolated
  std::array<float, neighbour_count> influence{};     // the mean of OddSystem::influence, for those that have none
};
Habits learn_habits(std::span<const OddSystem> systems);

/// Whether the lens plainly bends edges.
bool are_bent(const Habits& habits);

/// Whether glare plainly adds light.
bool are_glared(const Habits& habits);

/// By how much correlated noise enlarges a covariance.
double correlation_factor(const OddSystem& system, const Habits& habits);

}  // namespace handsight
