// SPDX-License-Identifier: Apache-2.0
// Unnamed functions of one thing (a joint's angle, a torque, another joint's angle, time, the place in the image),
// acting at a joint, at the TCP or at the mount. They keep the ranking honest: where one of them wins, the catalogue
// does not have what is missing, and the variable that it follows is known.
#pragma once

#include <memory>

#include "diagnosis/curves/curve_shapes.h"
#include "diagnosis/curves/site_scores.h"

namespace handsight {

/// One shape of one variable at one site, with its best linear estimate.
struct EmpiricalErrorTerm {
  EmpiricalErrorSite site = EmpiricalErrorSite::joint;
  int joint = -1;  // of the robot, where the site is a joint
  CurveShape shape;
  double ln_bayes_factor = 0;
  Eigen::VectorXd estimate;  // functions x site directions (1 or 6), row by row; rad, m
};

/// All shapes of one variable together.
struct EmpiricalError {
  std::shared_ptr<const Variable> variable;
  double ln_bayes_factor = 0;  // the mean over its shapes and sites
  EmpiricalErrorTerm best;
};

/// For every variable, under one assumption of scatter. `problem` is that of `w.model`.
std::vector<EmpiricalError> localise(const WhitenedModel& w, const NoiseKnowledge& noise, const Problem& problem,
                                     const std::vector<Variable>& variables);

}  // namespace handsight
