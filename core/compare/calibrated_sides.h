// SPDX-License-Identifier: Apache-2.0
// A calibration as the first side of a comparison. Internal to comparison.cpp and change_watch.cpp.
#pragma once

#include "compare/shared_model.h"
#include "correct/calibrated_robot.h"

namespace handsight {

/// The new session as the calibration knows it: its markers, its mount. InputError where they are not of one robot.
Session as_calibrated(const CalibratedRobot& before, const Session& after);

/// `session`: as_calibrated. InputError where no observation of it can be used.
ComparedSides make_sides(const CalibratedRobot& before, const Session& session, const Chain& chain);

}  // namespace handsight
