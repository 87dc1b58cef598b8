// SPDX-License-Identifier: Apache-2.0
// Levenberg-Marquardt on the normal equations of a Problem; one way of stepping for every objective.
#pragma once

#include <functional>

#include "estimation/solvers/loss.h"

namespace handsight {

struct SolveOptions {
  bool fixed_body = false;  // the markers move as one rigid body: 6 unknowns in place of 3 a marker
  int most_iterations = 100;
  double smallest_step = 1e-12;  // where the fit ends: m and rad, and thousandths of an effect's prior sigma
  double least_gain = 0;         // ... or where a step promises to lower the cost by less than this
  /// Steps shorter than this keep the effects' derivatives of before: quicker, and the answer is off by a share of the
  /// last such step, to which the cost is blind.
  double reuse_below = 0;
  Loss loss = Loss::none;
  double noise = 1;  // px or m: the noise of one coordinate, read by robust losses only
  /// Called after every accepted step with the iteration and the cost; returning false stops the fit there.
  std::function<bool(int iteration, double cost, const Unknowns&)> on_iteration;
};

struct Solution {
  Unknowns unknowns;
  bool converged = false;  // false too where a marker lies behind a camera that saw it: that is no answer
  bool stopped = false;    // by on_iteration
  double start_cost = 0;   // at the start; no solution costs more
  int iterations = 0;
  int unobservable = 0;    // directions of the unknowns that the measurements do not determine; left as they were
  NormalEquations normal;  // at the solution, all columns of the problem, weights of the loss included
  Eigen::MatrixXd basis;   // problem columns x unknowns: how the unknowns move the columns
};

/// From `start`, until no unknown moves by more than rounding. No step is taken that raises the cost; where the start
/// itself has none (it is not finite) it is given back, not converged.
Solution solve(const Problem& problem, const Unknowns& start, const SolveOptions& options = {});

/// The unknowns' covariance basis (basis^T H basis)^+ basis^T for unit noise (1 px or 1 m), by the problem's columns.
/// Unobservable directions and unseen markers are zero.
Eigen::MatrixXd unit_covariance(const Solution& solution);

}  // namespace handsight
