// SPDX-License-Identifier: GPL-3.0-or-later
// How the estimate came about, again: of a session that was played before and is opened anew.
#pragma once

#include <functional>

#include "estimation/online/online.h"
#include "widgets/plots/convergence_plot.h"

namespace handsight::app {

/// The observations that are used, one after the other by the labels that they have: what the play would show without
/// looking at images. Stops early where `goes_on` says no.
std::vector<OnlineStep> recalled_steps(const Session& session, const std::function<bool()>& goes_on);

/// What plots of convergence show after a step that has an estimate.
widgets::ConvergencePoint convergence_point(const OnlineStep& step);

/// Of the accepted steps that have an estimate.
std::vector<widgets::ConvergencePoint> list_convergence(const std::vector<OnlineStep>& steps);

}  // namespace handsight::app
