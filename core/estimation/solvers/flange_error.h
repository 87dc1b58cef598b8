// SPDX-License-Identifier: Apache-2.0
// A robot that is wrong about its own flange: in every observation the flange stands off by a small motion exp(delta),
// drawn anew. Of a robot of poses FlangeError has the sizes of its place and of its turns; of a robot with joints that
// of its place, and as FlangeError::turn that of each joint's error (rad; 0.3 m a rad where prismatic), which turns and
// shifts the flange as the joints stand. The motions are no unknowns: they are eliminated from the normal equations,
// which then weigh images and robot as either of them errs (generalised least squares).
#pragma once

#include "estimation/problem/problem.h"
#include "estimation/solvers/equation_sums.h"

namespace handsight {

/// What a flange error of each kind by 1 makes of the small motion of the TCP against the sensor, in the TCP's frame:
/// covariances.
struct FlangeErrorShares {
  Matrix6 place, turn;
};

/// Of an observation; of a robot with joints ProblemObservation::motion must be filled (with_motions).
FlangeErrorShares flange_error_shares(const Problem& problem, const ProblemObservation& observation);

/// The covariance of the motion for these sizes.
Matrix6 make_covariance(const FlangeErrorShares& shares, const FlangeError& error);

/// A matrix G with G G^T = `covariance`, which may be singular.
Matrix6 root_of_covariance(const Matrix6& covariance);

/// How the markers' columns move with the TCP (v, w in its frame): 3 markers x 6.
Eigen::Matrix<double, Eigen::Dynamic, 6> markers_by_motion(const Problem& problem,
                                                           const ProblemObservation& observation,
                                                           const Unknowns& unknowns);

/// What one observation says of the motion.
struct FlangeSums {
  Eigen::Matrix<double, Eigen::Dynamic, 6> shared;  // H of the problem's columns x the motion's six numbers
  Matrix6 own;                                      // H of these
  Vector6 gradient;
};

/// Of its normal equations `one` (both triangles).
FlangeSums flange_sums(const Problem& problem, const ProblemObservation& observation, const Unknowns& unknowns,
                       const NormalEquations& one);

/// By numbers z of the motion G z in place of the motion itself.
FlangeSums along(const FlangeSums& sums, const Matrix6& g);

/// Adds one observation's normal equations `one` (both triangles), Problem::flange_error eliminated.
void add_without_flange_error(const Problem& problem, const ProblemObservation& observation, const Unknowns& unknowns,
                              const NormalEquations& one, NormalEquations& normal);

}  // namespace handsight
