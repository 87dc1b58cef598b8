// SPDX-License-Identifier: Apache-2.0
// The normal equations of a problem's observations by the markers' positions in the TCP frame, the mount and the
// effects.
#pragma once

#include <span>

#include "chain/sighting.h"
#include "estimation/problem/problem.h"
#include "estimation/solvers/equation_sums.h"

namespace handsight {

/// Applies a step by the problem's columns: markers move by their three numbers (m, TCP frame), the mount by
/// mount_from_sensor * exp(v), the effects' numbers add.
Unknowns moved(const Problem& problem, const Unknowns& unknowns, const Eigen::VectorXd& step);

/// Adds one observation's normal equations at these unknowns, without priors. Only the lower triangle is written;
/// `complete` fills the rest.
void add_observation(const Problem& problem, const ProblemObservation& observation, const Unknowns& unknowns,
                     NormalEquations& normal);

/// The gradient alone of what add_observation adds.
Eigen::VectorXd compute_gradient(const Problem& problem, const ProblemObservation& observation,
                                 const Unknowns& unknowns);

/// The motion of the body against the sensor, in the sensor's frame, by the mount's columns and the effects': 6 x
/// (6 where the mount is estimated, + effects).
Eigen::Matrix<double, 6, Eigen::Dynamic> motion_by_columns(const Problem& problem,
                                                           const ProblemObservation& observation,
                                                           const Unknowns& unknowns);

/// Derivative of one sighting's rows by the effects' columns that act on cameras and markers alone: rows x effects.
Eigen::MatrixXd direct_by_effects(const Problem& problem, const ProblemObservation& observation,
                                  const Sighting& sighting, const SightingResidual& residual,
                                  const Vector3& x_in_sensor, const Matrix3& sensor_from_tcp_rotation);

/// Mirrors the lower triangle of the information matrix.
void complete(NormalEquations& normal);

/// The normal equations of the observations at these places of Problem::observations; all where empty. The problem
/// must stand at the unknowns' effects.
NormalEquations normal_equations(const Problem& problem, const Unknowns& unknowns, std::span<const int> places = {});

}  // namespace handsight
