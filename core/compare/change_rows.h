// SPDX-License-Identifier: Apache-2.0
// Observations of one side of a comparison, linearised and summed up: what the unknowns that both sides share, and what
// may have changed on this side, do to them. Internal to comparison.cpp.
#pragma once

#include "compare/shared_curves.h"

namespace handsight {

/// One observation in units of the noise. Columns: shared unknowns, then changes in units of their prior sigma.
struct ChangeObservation {
  Eigen::Matrix<double, 6, Eigen::Dynamic>
      body_by_columns;                      // B^T J, B: rows by the body's motion in the sensor's frame
  Vector6 body_by_error = Vector6::Zero();  // B^T e
  Matrix6 body_squares = Matrix6::Zero();   // B^T B
};

struct ChangeRows {
  std::vector<ChangeObservation> observations;
  Eigen::MatrixXd information;  // J^T J over all
  Eigen::VectorXd gradient;     // J^T e
  double squares = 0;           // e^T e
  int rows = 0;

  void add(const ChangeRows& other);
};

/// The unknowns of a comparison: those of the first side's model, which both share.
struct SharedState {
  Unknowns unknowns;
  Eigen::VectorXd curves;  // numbers of the shared curves, in their prior sigmas
  Eigen::VectorXd moved;   // how far all shared columns went from their start; read where they have a prior there
};

/// Columns: markers, mount where it is estimated, shared effects, shared curves, changes.
struct ChangeColumns {
  Eigen::Index effects = 0;  // shared ones: the first effect columns of a problem; the others are changes
  const std::vector<SharedCurve>* curves = nullptr;
  Eigen::Index curve_columns = 0;
  Eigen::Index changes = 0;

  Eigen::Index shared(const Problem& p) const { return p.effect_column() + effects + curve_columns; }
};

/// `problem` stands at the values of its effects in `state`. `weight`: of each row (the noise's inverse).
ChangeRows change_rows(const Problem& problem, const SharedState& state, const ChangeColumns& columns, double weight);

/// The same with the shared markers replaced by a rigid motion xi of all of them (6 columns): where their shape is
/// known.
ChangeRows with_rigid_markers(const ChangeRows& rows, const std::vector<Vector3>& markers_in_tcp);

/// The rows of one observation in the order of its sightings, in units of the noise; columns as with_rigid_markers.
struct SingleRows {
  Eigen::MatrixXd by_columns, by_body;  // by_body: by the body's motion in the sensor's frame
  Eigen::VectorXd error;
};
SingleRows single_rows(const Problem& problem, const ProblemObservation& observation, const SharedState& state,
                       const ChangeColumns& columns, double weight);

/// Normal equations where every observation's body is off by a draw of its own with this covariance (sensor frame, m
/// and rad).
struct ScatteredNormal {
  Eigen::MatrixXd information;
  Eigen::VectorXd gradient;
  double squares = 0;
};
ScatteredNormal scattered(const ChangeRows& rows, const Matrix6& repeatability);

/// What a step of the columns leaves beside the noise.
struct LeftOver {
  double p = 1;                             // probability of so much or more by noise alone
  Matrix6 repeatability = Matrix6::Zero();  // covariance of the body's motions that it is, by expectation and
                                            // maximisation; zero where it is no more than noise (p > 1e-3)
};

/// Of what is left that is more than noise.
inline constexpr double more_than_noise = 1e-3;

/// What observations are off by, and how much each shows of a motion of the body.
struct BodyErrors {
  std::vector<Vector6> errors;        // B^T e
  std::vector<Matrix6> body_squares;  // B^T B
};

/// LeftOver::scatter of these.
Matrix6 repeatability_of(const BodyErrors& left);

/// `parameters`: how many the step was fitted with; `noise_degrees`: of freedom that the noise was estimated from, 0
/// where it is declared.
LeftOver left_over(const ChangeRows& rows, const Eigen::VectorXd& step, double parameters, double noise_degrees);

}  // namespace handsight
