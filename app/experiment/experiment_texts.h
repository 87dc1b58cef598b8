// SPDX-License-Identifier: GPL-3.0-or-later
// What an experiment says, in the window's language.
#pragma once

#include <QString>

#include "experiment/experiment_run.h"

namespace handsight::app {

/// Why this session cannot be measured by a driver; empty where it can.
QString why_no_experiment(const Session& session);

/// What is going on: "The robot moves to pose 3 of 5: to settle the estimate."
QString state_text(RunState state, const QString& driver, bool is_of_touches);

/// What a pose is for: "to settle the estimate".
QString reason_in_words(PoseReason reason);

/// "The hand is known to 0.31 mm (95 %)."
QString hand_text(const Knowledge& known, bool has_box, bool is_of_touches);
/// "What was found so far: ..."
QString verdict_in_words(const Knowledge& known);

/// The two likeliest causes, each with its odds against none.
struct CauseInWords {
  QString cause, odds;
};
std::vector<CauseInWords> likeliest_causes(const Knowledge& known);

/// "observation 12: taken", "not taken: ..."
QString step_text(const ExperimentStep& step);

/// "0.8 rad", "0.8 rad, round by 3 points": the way to a pose.
QString way_text(const PlannedMove& move);

/// The fixture that is touched from there; empty: it is looked from.
QString touched_by(const ChosenPose& pose, const Session& session);

/// What it is asked: "The robot moves now: 5 poses at first, ..."
QString question_text(std::size_t poses, double speed, bool is_of_touches);

}  // namespace handsight::app
