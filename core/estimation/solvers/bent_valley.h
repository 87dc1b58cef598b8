// SPDX-License-Identifier: Apache-2.0
// Where a step of a search along a bent valley led up its side: from there, back down to its floor.
#pragma once

#include <functional>

#include "estimation/problem/problem.h"
#include "estimation/solvers/equation_sums.h"

namespace handsight {

/// The normal equations at other unknowns, with the effects' derivatives there or those of before.
using NormalAt = std::function<NormalEquations(const Unknowns&, bool derives)>;

struct ValleyStep {
  Eigen::VectorXd step;    // as it was taken, one number for each column of step_basis
  double promised = 0;     // what it was to lower the cost by, by the equations where it began
  double cost_before = 0;  // where it began
  double damping = 0;      // of the step
  bool fixed_body = false;
};

/// Takes `next` and its equations, where the step led and costs more than before, on to where it costs less. False
/// where nothing leads there: then both are left as they were.
bool lead_to_floor(const Problem& problem, const ValleyStep& taken, const NormalAt& normal_at, Unknowns& next,
                   NormalEquations& normal);

}  // namespace handsight
