// SPDX-License-Identifier: Apache-2.0
// All measured coordinates of one observation and how they follow from every column of a problem.
#pragma once

#include "chain/sighting.h"
#include "estimation/problem/problem.h"
#include "geometry/rigid.h"
#include "session/session.h"

namespace handsight {

/// How the rows of one sighting follow from all columns of the problem: rows x columns. `motion` is
/// motion_by_columns of the observation, `x` the marker in the sensor's frame.
Eigen::MatrixXd by_columns(const Problem& problem, const ProblemObservation& o, const Sighting& s, const Vector3& x,
                           const SightingResidual& residual, const Matrix3& sensor_from_tcp_rotation,
                           const Eigen::Matrix<double, 6, Eigen::Dynamic>& motion);

/// Rows of one observation: measured - predicted (px or m) and their derivatives; sightings' weights taken in.
struct ObservationRows {
  Eigen::VectorXd error;
  Eigen::MatrixXd by_columns;  // rows x columns of the problem
};

ObservationRows observation_rows(const Problem& problem, const ProblemObservation& o, const Unknowns& unknowns);

}  // namespace handsight
