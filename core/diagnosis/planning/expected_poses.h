// SPDX-License-Identifier: Apache-2.0
// What a fitted model expects to see in poses that were not measured yet, and what measuring them would teach it.
#pragma once

#include <Eigen/Cholesky>

#include "diagnosis/planning/pose_pool.h"

namespace handsight {

/// Half of ln det of the matrix that was factored.
inline double half_ln_determinant(const Eigen::LLT<Eigen::MatrixXd>& llt) {
  return llt.matrixLLT().diagonal().array().log().sum();
}

/// The coordinates of one pose, all in units of the noise.
struct ExpectedRows {
  Eigen::MatrixXd by_columns;  // rows x the problem's columns
  Eigen::VectorXd predicted;   // rows
  bool is_shown = true;        // as the model places it, springs included
};

/// A model linearised where its fit stands, with the information that it has so far.
class ExpectedPoses {
 public:
  /// `noise` of one coordinate, px or m.
  ExpectedPoses(const Fit& fit, double noise);

  /// Linearises these poses, each as if it was approached from `before`, at rest, after all that was measured.
  void look_at(const std::vector<Eigen::VectorXd>& poses, const Eigen::VectorXd& before, const PoseJudge& judge);

  /// The same of postures that touch these fixtures of the fit's session.
  void look_at(const std::vector<Eigen::VectorXd>& poses, const Session& session, const std::vector<int>& fixtures,
               const Eigen::VectorXd& before, const PoseJudge& judge);
  const ExpectedRows& rows(std::size_t pose) const { return rows_[pose]; }

  /// Takes the measurement of a pose into the information.
  void measure(const ExpectedRows& rows);

  /// L^-1 B^T with L L^T the information: columns are the pose's rows, in which its own information is S = W^T W.
  Eigen::MatrixXd whitened(const ExpectedRows& rows) const;
  const Eigen::LLT<Eigen::MatrixXd>& information() const { return llt_; }

  /// sigma of tcp_from_body (m, rad) by the information so far; rotations that one or two markers cannot show are left
  /// out.
  Vector6 sigma_of_body() const;

  /// Do the effects of the model depend on where a pose is approached from, or on how fast it is passed?
  bool depends_on_approach() const;
  bool depends_on_velocity() const;

 private:
  /// What is seen of each pose, and by which part of a session of touches; -1: it is none.
  struct Look {
    std::vector<Sighting> sightings;
    int part = -1;
  };
  void linearise(const std::vector<Eigen::VectorXd>& poses, const std::vector<Look>& looks,
                 const Eigen::VectorXd& before, const PoseJudge& judge);
  ExpectedRows rows_at(const Problem& problem, const ProblemObservation& o, const PoseJudge& judge) const;

  const Fit& fit_;
  double noise_;
  Eigen::MatrixXd information_;
  Eigen::LLT<Eigen::MatrixXd> llt_;
  std::vector<ExpectedRows> rows_;
};

/// `like` with these poses in place of its observations: each approached from `before`, at rest, all markers that were
/// seen looked at and found where nothing is. Not of touches.
Problem expected_problem(const Problem& like, const Unknowns& unknowns, const Rigid& tcp_from_body,
                         const std::vector<Eigen::VectorXd>& poses, const Eigen::VectorXd& before);

}  // namespace handsight
