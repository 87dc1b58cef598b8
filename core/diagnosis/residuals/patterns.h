// SPDX-License-Identifier: Apache-2.0
// See where a model fails: residual motions of the body that follow something, by a statistic that assumes no shape.
#pragma once

#include "base/message.h"
#include "diagnosis/curves/variables.h"
#include "diagnosis/evidence/linear_model.h"

namespace handsight {

/// One residual quantity per observation: a motion of the body along an axis, or the error of one joint that would
/// explain the residual.
struct ResidualSeries {
  Message name;            // "z of the TCP", "angle of arm_2"
  std::string unit;        // m or rad
  int joint = -1;          // of the robot, where it is a joint's equivalent error
  Eigen::VectorXd values;  // per observation
  Eigen::VectorXd sigmas;  // of the noise alone
};

struct Pattern {
  std::size_t series = 0, variable = 0;  // into the lists given
  double strength = 0;  // share of the residual's square that a smooth curve over the variable explains
  double p_value = 1;   // under sign flips of whole observations, times the number of pairs looked at
};

/// How a residual quantity follows from the external rows of the observations.
struct ResidualAxis {
  Message name;
  std::string unit;
  int joint = -1;
  std::vector<Eigen::RowVectorXd> weights;  // per observation, by its external rows; zero where it shows nothing
};

/// Motions along the axes of TCP, root and image (18), and per-joint equivalent errors.
std::vector<ResidualAxis> residual_axes(const Problem& problem, const LinearModel& model);
/// The quantity in external rows `error` (of all observations, in units of the noise).
Eigen::VectorXd seen_along(const ResidualAxis& axis, const LinearModel& model, const Eigen::VectorXd& error);
/// All of them in the model's own residuals.
std::vector<ResidualSeries> residual_series(const Problem& problem, const LinearModel& model);

/// All pairs, most structured first: those with p below 1e-3 by strength, then the others by p-value.
std::vector<Pattern> find_patterns(const std::vector<ResidualSeries>& series, const std::vector<Variable>& variables);

}  // namespace handsight
