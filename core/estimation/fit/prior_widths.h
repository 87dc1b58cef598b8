// SPDX-License-Identifier: Apache-2.0
// How far an effect's numbers may be from zero: their priors have heavy tails.
#pragma once

#include <vector>

#include "estimation/solvers/least_squares.h"

namespace handsight {

/// The widths that fit values from a fit before (one for each effect number): where the next one starts, so that it
/// need not come back from where narrower priors would pull it.
void start_prior_widths(Problem& problem, const Eigen::VectorXd& values);

/// A number's prior is a mixture of normal distributions about 0 whose sigmas are its prior sigma, 5 and 25 times
/// that: most are as large as is usual, a few are far off. Takes for every effect of the robot, hand and mount the
/// width that is likeliest for what the measurements alone say of it (the evidence of one number, all others at their
/// priors), so that what they determine is not held back. Numbers of the cameras have a rule of their own
/// (widen_refuted). True where a number is pulled otherwise than before by a twentieth of its sigma or more: then the
/// solution is no longer the problem's.
bool settle_prior_widths(Problem& problem, const Solution& solution);

/// The same for fits that need not be exact, those of the candidates of a diagnosis: the widths that fit the values
/// themselves. Where two numbers may stand for each other, what the measurements say of either depends on the other's
/// width, and their widths take turns; a value that a wide prior lets stand asks for the wide one again, and what a
/// narrow one holds back for the narrow one. True where any is another.
bool take_widths_of_values(Problem& problem, const Solution& solution);

/// One for each effect number, in units of its prior sigma.
using Widths = std::vector<double>;
Widths list_widths(const Problem& problem);

/// Widths that come again would take turns for ever: each number keeps the widest that it had in the circle, wherever
/// that was entered. False where the problem's have not come before; they are then added to `before`.
bool end_circle(std::vector<Widths>& before, Problem& problem);

/// Where nothing tells the noise, what the solution leaves stands in for it: else priors would be weighed against a
/// guess. Has it changed by more than a few per cent?
bool settle_guessed_noise(Problem& problem, const Solution& solution, double finest);

}  // namespace handsight
