// SPDX-License-Identifier: Apache-2.0
// What residuals may follow: joint angles, gravity torques, directions of approach, time, the place in the image.
#pragma once

#include <string>
#include <vector>

#include "base/message.h"
#include "estimation/problem/problem.h"

namespace handsight {

enum class VariableKind { angle, torque, approach, time, order, image_u, image_v, depth };

struct Variable {
  VariableKind kind = VariableKind::time;
  int joint = -1;  // of the robot, for angle, torque and approach
  Message name;    // as a user reads it
  std::string unit;
  Eigen::VectorXd values;  // per observation of the problem
  /// As effects.xml writes it (q_arm_3, "(0.2 + 0.98*tcp_x)"), and what that gives where it is not `values`: places are
  /// those of the markers' middle here, of the TCP there. Empty: no formula can say it.
  std::string formula = {};
  Eigen::VectorXd written_values = {};

  double range() const { return values.size() ? values.maxCoeff() - values.minCoeff() : 0; }
};

/// The same with the values that its formula gives.
Variable as_written(const Variable& v);

/// Those that vary over the observations. `problem` must hold torques (EffectMotion); a mimic joint has an angle and a
/// torque like any other.
std::vector<Variable> list_variables(const Problem& problem, const Unknowns& unknowns);

}  // namespace handsight
