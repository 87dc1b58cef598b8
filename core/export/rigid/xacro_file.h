// SPDX-License-Identifier: Apache-2.0
// The calibrated URDF as a macro of xacro.
#pragma once

#include "export/rigid/described_robot.h"

namespace handsight {

/// A file to include: the macro `calibrated_robot` with the parameters `name` (put before every link and joint with an
/// underscore; empty: nothing) and `parent` (a link that the root is fixed to; empty: none).
std::string xacro_file(const DescribedRobot& robot);

}  // namespace handsight
