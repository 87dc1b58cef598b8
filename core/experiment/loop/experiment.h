// SPDX-License-Identifier: Apache-2.0
// The loop: choose poses, drive there, look, decide, fit, and stop when enough is known.
#pragma once

#include "experiment/driver/driven_robot.h"
#include "experiment/loop/experiment_result.h"

namespace handsight {

/// Drives until the goals are reached. Where a driver fails it is asked to stop and the result says so; what was
/// measured until then is in the session, on disk too. InputError where session and driver do not belong together,
/// where the program has no paths (what_paths_need), or where the session cannot be written.
ExperimentResult run_experiment(Session session, DrivenRobot& robot, const ExperimentOptions& options);

}  // namespace handsight
