// SPDX-License-Identifier: Apache-2.0
// Robust losses: how much a sighting with a long residual counts.
#pragma once

#include "estimation/problem/problem.h"
#include "estimation/solvers/equation_sums.h"

namespace handsight {

/// Robust losses on the length of one sighting's residual in units of the noise; they bend at the tuning constant.
enum class Loss { none, huber, cauchy };

/// Where a loss bends, its tuning constant, in units of the noise: the length that noise alone exceeds once in 20 (chi,
/// 2 rows to 16).
double tuning_constant(int rows);

/// A loss rho of a squared length s, scaled so that it is s near 0.
struct LossValue {
  double weight = 1;     // d rho / d s
  double cost = 0;       // rho, in the unit of s
  double curvature = 0;  // d^2 rho / d s^2
};

/// `noise` is that of one coordinate, in the unit of the residual (px, m).
LossValue loss_at(Loss loss, double squared_length, int rows, double noise);

/// The normal equations with the loss's weights at these unknowns; `cost` is the loss, not the weighted squares. The
/// weights stay in the problem's observations.
NormalEquations weighted_normal_equations(Problem& problem, const Unknowns& unknowns, Loss loss, double noise);

}  // namespace handsight
