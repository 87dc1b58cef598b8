// SPDX-License-Identifier: Apache-2.0
// The calibrated arm as tables of Denavit-Hartenberg parameters.
#pragma once

#include "export/rigid/described_robot.h"

namespace handsight {

enum class TableForm { csv, yaml };

/// Both conventions (dh.h) with the transforms of base and tool, from the root to the hand. InputError where no joint
/// moves the hand.
std::string dh_file(const DescribedRobot& robot, TableForm form);

}  // namespace handsight
