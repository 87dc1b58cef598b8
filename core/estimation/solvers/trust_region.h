// SPDX-License-Identifier: Apache-2.0
// The same minimum as `solve`, by Ceres' trust region with our derivatives: for fits that must not get lost.
#pragma once

#include "estimation/solvers/least_squares.h"

namespace handsight {

/// What `solve` minimises, from the same start: a residual a sighting in units of the noise with the loss on its length
/// and a residual a prior; mount and body move on their manifolds. Ends where `solve` does; SolveOptions::reuse_below
/// is not read. About a fifth slower than `solve` near the answer (docs/measurements.md), at home farther from it.
Solution solve_by_trust_region(const Problem& problem, const Unknowns& start, const SolveOptions& options = {});

}  // namespace handsight
