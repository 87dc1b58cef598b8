// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "estimation/problem/problem.h"

namespace handsight {

/// The rows of one observation, sighting by sighting (u, v of each camera, or x, y, z): by the six small motions of
/// the body in the sensor's frame (n x 6), and measured - predicted (n), px or m.
struct BodyRows {
  Eigen::MatrixXd by_body;
  Eigen::VectorXd error;
};

BodyRows body_rows(const Problem& problem, const ProblemObservation& o, const Unknowns& u);

}  // namespace handsight
