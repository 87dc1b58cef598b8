// SPDX-License-Identifier: Apache-2.0
// Two sessions of one robot, weeks apart, or a calibration and a session: what one change explains the difference.
#pragma once

#include <functional>
#include <vector>

#include "compare/comparison_result.h"
#include "correct/calibrated_robot.h"
#include "diagnosis/residuals/residual_views.h"

namespace handsight {

/// Two sessions of one robot with the same markers. `effects`: in the model of both, estimated. InputError where they
/// are not of one robot, device and number of markers.
Comparison compare(const Session& before, const Session& after, const std::vector<EffectTerm>& effects = {},
                   const ComparisonProgress& progress = {});

/// A few poses of a session against a calibration: whether camera, hand and arm are as they were.
Comparison compare(const CalibratedRobot& before, const Session& after, const ComparisonProgress& progress = {});

/// A corner of a session where it was measured, less where a calibration has it.
struct CalibrationResidual {
  int observation = 0;  // into Session::observations
  CornerResidual corner;
};

/// Every corner of the session that is used, against the calibration as it stands: nothing is fitted. InputError as
/// `compare`.
std::vector<CalibrationResidual> compute_residuals(const CalibratedRobot& before, const Session& after);

/// Two calibrations: their numbers, and the hand over poses drawn from the joints' limits.
Comparison compare(const CalibratedRobot& before, const CalibratedRobot& after);

}  // namespace handsight
