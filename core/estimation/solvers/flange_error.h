// SPDX-License-Identifier: Apache-2.0
// A robot that is wrong about its own flange: in every observation the flange stands off by a small motion exp(delta),
// drawn anew, with place and turn of these sizes. The motions are no unknowns: they are eliminated from the normal
// equations, which then weigh images and robot as either of them errs (generalised least squares).
#pragma once

#include "estimation/problem/problem.h"
#include "estimation/solvers/equation_sums.h"

namespace handsight {

/// tcp_from_flange in one observation of a robot of poses, whichever end of the chain the flange carries.
Rigid tcp_from_flange(const Problem& problem, const ProblemObservation& observation);

/// How the markers' columns move by the flange's error (v, w in the flange's frame): 3 markers x 6.
Eigen::Matrix<double, Eigen::Dynamic, 6> markers_by_flange(const Problem& problem,
                                                           const ProblemObservation& observation,
                                                           const Unknowns& unknowns);

/// What one observation says of the flange's error.
struct FlangeSums {
  Eigen::Matrix<double, Eigen::Dynamic, 6> shared;  // H of the problem's columns x the error's six numbers
  Matrix6 own;                                      // H of these
  Vector6 gradient;
};

/// Of its normal equations `one` (both triangles).
FlangeSums flange_sums(const Problem& problem, const ProblemObservation& observation, const Unknowns& unknowns,
                       const NormalEquations& one);

/// The weight (noise / sigma)^2 of the error's six numbers; problem.flange_error must be of some size.
Vector6 flange_error_weights(const FlangeError& error, double noise);

/// Adds one observation's normal equations `one` (both triangles), Problem::flange_error eliminated.
void add_without_flange_error(const Problem& problem, const ProblemObservation& observation, const Unknowns& unknowns,
                              const NormalEquations& one, NormalEquations& normal);

}  // namespace handsight
