// SPDX-License-Identifier: Apache-2.0
// Observations of one side of a comparison, linearised and summed up: what the unknowns that both sides share, and what
// may have changed on this side, do to them. Internal to comparison.cpp.
#pragma once

#include "estimation/problem.h"

namespace handsight {

/// One observation in units of the noise. Columns: shared unknowns, then changes in units of their plausible size.
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

/// `problem` stands at its effects' values, which are `unknowns.effects`; its first `base_effects` effect columns are
/// shared, the others changes of this side. `columns`: how many columns in all, changes of other units among them;
/// `first_change`: where this problem's changes begin. `weight`: of each row (the noise's inverse).
ChangeRows change_rows(const Problem& problem, const Unknowns& unknowns, Eigen::Index base_effects,
                       Eigen::Index first_change, Eigen::Index columns, double weight);

/// The same with the shared markers replaced by a rigid motion xi of all of them (6 columns): where their shape is
/// known.
ChangeRows with_rigid_markers(const ChangeRows& rows, const std::vector<Vector3>& markers_in_tcp);

/// Normal equations where every observation's body is off by a draw of its own with this covariance (sensor frame, m
/// and rad).
struct ScatteredNormal {
  Eigen::MatrixXd information;
  Eigen::VectorXd gradient;
  double squares = 0;
};
ScatteredNormal scattered(const ChangeRows& rows, const Matrix6& scatter);

/// The covariance of the body's motions that a step of the columns leaves, by expectation and maximisation; zero where
/// what it leaves is no more than noise (p > 1e-3). `parameters`: how many the step was fitted with.
Matrix6 scatter_left(const ChangeRows& rows, const Eigen::VectorXd& step, int parameters);

}  // namespace handsight
