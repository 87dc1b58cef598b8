// SPDX-License-Identifier: Apache-2.0
// Is a slip at one moment believable? It is cheap to add and costly when wrong.
#pragma once

#include "estimation/fit_report.h"

namespace handsight {

/// The first moment from which on one of the terms acts (an observation's order); none where no term has one.
std::optional<double> slip_order(const std::vector<EffectTerm>& terms);

/// A slip that is real lowers what is left of observations on both sides of it when blocks of time, not only single
/// folds of neighbours, are held out, and by more than a likelihood with heavy tails (Student, 4 degrees) allows
/// chance: odds of 20 on the whole. `without` and `with` are fits of the same session, with their options.
bool slip_is_confirmed(const Session& session, const Fit& without, const FitOptions& without_options, const Fit& with,
                       const FitOptions& with_options, double order);

}  // namespace handsight
