// SPDX-License-Identifier: Apache-2.0
// Number by number, what two estimates of one model differ by. Internal to comparison.cpp.
#pragma once

#include "compare/comparison_result.h"

namespace handsight {

/// The six numbers of a motion, as what is between the two; `covariance` of that.
void add_motion(std::vector<NumberChange>& all, const std::string& name, const Rigid& a, const Rigid& b,
                const Matrix6& covariance);

/// Of effects that both have; the variances in the order of the terms' values.
void add_effects(std::vector<NumberChange>& all, const Robot& robot, const std::vector<EffectTerm>& a,
                 const Eigen::VectorXd& variance_a, const std::vector<EffectTerm>& b,
                 const Eigen::VectorXd& variance_b);

}  // namespace handsight
