// SPDX-License-Identifier: Apache-2.0
// What the last steps of a search tell of its next one. Gauss and Newton's equations leave out the residuals' second
// derivatives: where a model leaves much more than noise, or hardly determines a direction, their steps go too far or
// not far enough along a few directions, by the same share again and again.
#pragma once

#include <Eigen/Core>
#include <deque>

namespace handsight {

/// Anderson's mixing (D. G. Anderson 1965; H. F. Walker and P. Ni 2011) of steps, in the metric of the information: how
/// the equations' steps changed over the steps that were taken tells where none would be left.
class LearnedStep {
 public:
  /// The step to take from a place where the equations say `plain`; all steps have n numbers. `information` (n x n) and
  /// `gradient` are the equations' own: a step against the gradient is not taken.
  Eigen::VectorXd next(const Eigen::VectorXd& plain, const Eigen::MatrixXd& information,
                       const Eigen::VectorXd& gradient);

  /// The last `plain` led on by this step. Did it keep what it promised? Then steps may reach farther.
  void took(const Eigen::VectorXd& step, bool kept_promise);

  /// It led nowhere: the next step from the same place reaches less far.
  void refused();

  /// The equations are no longer those of before: nothing that was seen counts.
  void forget();

  bool has_learned() const { return !changes_.empty(); }

 private:
  std::deque<Eigen::VectorXd> steps_, changes_;  // taken, and what that changed of `plain`; the oldest first
  Eigen::VectorXd taken_, plain_;                // the last ones; empty: none
  double reach_ = 10, size_ = 1;                 // times the plain step: at most, and the last one
};

}  // namespace handsight
