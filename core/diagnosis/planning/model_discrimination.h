// SPDX-License-Identifier: Apache-2.0
// Two models of the same measurements, and how well new poses would tell which is true: symmetric T-optimality with
// the uncertainty of both models' parameters (docs/method.md, "Next poses").
#pragma once

#include <array>

#include "diagnosis/planning/expected_poses.h"

namespace handsight {

/// A model and its rival: the first is true, what will the second make of new measurements? Which measurements come is
/// not known; they shift both estimates, in ways that belong together.
class ModelDiscrimination {
 public:
  ModelDiscrimination(const ExpectedPoses& truth, const ExpectedPoses& rival) : truth_(&truth), rival_(&rival) {}

  /// The ln Bayes factor for the truth that measuring a pose adds, expected over all that may be measured in it and in
  /// the poses before it.
  double expected(const ExpectedRows& by_truth, const ExpectedRows& by_rival) const;

  /// What the measurement of a pose does to both; before the models themselves have measured it.
  void measure(const ExpectedRows& by_truth, const ExpectedRows& by_rival);

 private:
  /// Rows x n: how unknown measurements of before move the difference of the two predictions.
  Eigen::MatrixXd wandering(const ExpectedRows& by_truth, const ExpectedRows& by_rival) const;
  Eigen::VectorXd difference(const ExpectedRows& by_truth, const ExpectedRows& by_rival) const;

  const ExpectedPoses* truth_;
  const ExpectedPoses* rival_;
  Eigen::VectorXd rival_shift_;  // mean shift of the rival's estimate by measurements so far; empty: none
  Eigen::MatrixXd truth_wander_, rival_wander_;  // shifts by independent unit normal numbers
};

}  // namespace handsight
