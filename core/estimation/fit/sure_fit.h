// SPDX-License-Identifier: Apache-2.0
// The minimum of a fit, made sure of: a start that leads nowhere is exchanged, a prior that the measurements refute
// gives way.
#pragma once

#include "estimation/fit/fit_result.h"
#include "session/session.h"

namespace handsight {

/// An effect of the cameras whose value is more than five times what is plausible: its priors refuted by what the
/// measurements say, its prior sigmas become ten times as large, again until it is not. True where one was. Other
/// effects keep theirs, which the diagnosis weighs by.
bool widen_refuted(Problem& problem, const Eigen::VectorXd& values);

/// How many times larger than its own the prior sigmas of a term of the problem are taken; 1 where they are its own.
double widened_by(const Problem& problem, std::size_t term);

/// `minimise`, priors that are refuted widened in `images` and the fit's problem, to the narrowest that what is found
/// does not refute; then, unless a quick answer is asked for or the fit's objective is not that of the images, where it
/// looks lost from other starts too. The end with the least squares in the measurements is kept; what `is_no_answer`
/// has not converged. `images` may be the fit's own problem.
void minimise_surely(const Session& session, Problem& images, const Unknowns& start, const FitOptions& options,
                     double noise, Fit& fit);

/// Is the fit none that anybody should use a number of (`is_no_answer`)? Of other objectives than the images only by
/// the markers behind cameras.
bool has_no_answer(const Fit& fit);

}  // namespace handsight
