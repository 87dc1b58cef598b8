// SPDX-License-Identifier: Apache-2.0
// Steps of a problem's unknowns: how they move the columns, and those that normal equations ask for.
#pragma once

#include "estimation/problem/problem.h"
#include "estimation/solvers/equation_sums.h"

namespace handsight {

/// Steps of the unknowns to columns of the problem: the identity, or with a fixed body its six small motions.
Eigen::MatrixXd step_basis(const Problem& problem, const Unknowns& unknowns, bool fixed_body);

/// The unknowns after a step (one number for each column of the basis).
Unknowns stepped(const Problem& problem, const Unknowns& unknowns, const Eigen::VectorXd& step, bool fixed_body);

/// The information of the steps; of free markers the basis is the identity, and large.
Eigen::MatrixXd by_steps(const Eigen::MatrixXd& information, const Eigen::MatrixXd& basis, bool fixed_body);
Eigen::VectorXd gradient_by_steps(const NormalEquations& normal, const Eigen::MatrixXd& basis, bool fixed_body);

/// (H + damping D) step = gradient in the scaled unknowns; a pseudo-inverse where H does not determine them all.
Eigen::VectorXd damped_step(const Eigen::MatrixXd& h, const Eigen::VectorXd& gradient, double damping);

/// The damped step that goes neither on nor back `along` another one, in the metric of the damping.
Eigen::VectorXd damped_step_across(const Eigen::VectorXd& along, const Eigen::MatrixXd& h,
                                   const Eigen::VectorXd& gradient, double damping);

}  // namespace handsight
