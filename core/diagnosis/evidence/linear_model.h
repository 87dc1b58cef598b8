// SPDX-License-Identifier: Apache-2.0
// A fitted model and candidates for what it lacks, linearised: rows in units of the noise, effects in units of their
// prior sigma (markers and mount in m and rad). In every observation the six motions of the body part the rows in
// two: the external ones, which anything may explain, and the internal ones, which only cameras and markers can.
#pragma once

#include "chain/chain.h"
#include "estimation/problem/problem.h"
#include "geometry/rigid.h"

namespace handsight {

struct LinearObservation {
  Eigen::Index first = 0;         // external row
  Eigen::Index count = 0;         // 6, or fewer where the sightings do not determine the body's pose
  Eigen::MatrixXd by_body;        // external rows by the body's motion in the sensor's frame: count x 6
  Eigen::MatrixXd joint_motions;  // the body's motion in the sensor's frame by those values: 6 x joints
  Eigen::MatrixXd by_joints;  // ... by the values of the chain's joints (rad; 0.3 m where prismatic): count x joints
  Rigid sensor_from_tcp;
  int internal = 0;  // internal rows
  double internal_squares = 0;
};

/// What is known of the base beforehand, as one more measurement.
struct BasePrior {
  Eigen::VectorXd precision;  // 1 for its effects, 0 where flat
  Eigen::VectorXd gradient;   // -precision * value
  double cost = 0;            // value^T precision value
};

struct LinearModel {
  std::vector<LinearObservation> observations;
  Eigen::Index base = 0;                  // columns of the model: markers, mount, its effects
  Eigen::MatrixXd external;               // rows x (base + candidates)
  Eigen::VectorXd external_error;         // measured - predicted
  std::vector<Eigen::Index> internal_of;  // per candidate: its place in `internal`, or -1
  /// J^T J of the internal rows; columns: base, the candidates that have internal rows, the error.
  Eigen::MatrixXd internal;
  BasePrior prior;
  int rows = 0;
  int internal_rows = 0;

  Eigen::Index candidates() const { return external.cols() - base; }
};

/// By how much more than its prior sigma a number of the model is let, which is so many prior sigmas: three of
/// them surprise nobody, and what is clearly larger is so whatever is added. Held at its prior sigma it would be
/// cheaper in parts, and anything that can carry a part of it would seem to be there.
double times_prior_sigma(double in_prior_sigmas);

/// `problem` stands at `unknowns`; its first `base_effects` effect columns are the model's, the others candidates.
/// `noise` is that of one coordinate (px or m).
LinearModel linear_model(const Problem& problem, const Unknowns& unknowns, Eigen::Index base_effects, double noise);

}  // namespace handsight
