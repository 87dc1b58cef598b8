// SPDX-License-Identifier: Apache-2.0
// The poses over which a file of rigid links has to be right.
#pragma once

#include "correct/calibrated_robot.h"

namespace handsight {

struct ExportPoses {
  std::vector<ObservationState> measured;  // the session's, driven to one after another; else drawn within the limits
  std::vector<ObservationState> between;   // each between two of them, drawn
  bool are_measured = false;
};

/// At most 300 and 100. The chain of `robot` must outlive them. The same for the same robot.
ExportPoses export_poses(const CalibratedRobot& robot);

}  // namespace handsight
