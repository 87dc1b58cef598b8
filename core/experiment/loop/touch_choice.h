// SPDX-License-Identifier: Apache-2.0
// Which touches come next, from where they begin, and whether what was read can be one.
#pragma once

#include "estimation/online/online_step.h"
#include "experiment/driver/driven_robot.h"
#include "experiment/loop/choice.h"

namespace handsight {

/// Up to `count` touches: for the two causes that cannot be distinguished, the rest for the precision of the model with
/// what is likely, and one that is repeated. Each begins `touch_clearance` before the fixture; of lengths, whose ends
/// are put on, where it is read. Fewer, or none, where there are no more. `known` has a fit.
std::vector<ChosenPose> choose_touches(const Session& session, const ExperimentModel& model, const Knowledge& known,
                                       const Reach& reach, const ChoiceOptions& options);
inline constexpr double touch_clearance = 0.02;  // m

/// What was read, as an observation. DriverFault where another fixture was touched than was asked for, or where a
/// length has no value.
Observation observation_of_touch(const Session& session, int fixture, const TouchAnswer& answer,
                                 const Eigen::VectorXd& position);

/// Taken, unless the tip was much farther from the fixture than the fit has it: then it touched something else.
OnlineStep decided_touch(const Fit& fit, const Session& session, const Observation& observation);

}  // namespace handsight
