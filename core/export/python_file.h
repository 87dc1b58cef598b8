// SPDX-License-Identifier: Apache-2.0
// The corrected hand pose as one Python 3 file that needs the standard library alone.
#pragma once

#include <string>

#include "export/program_types.h"

namespace handsight {

/// To be imported (hand_pose, body_pose, nominal_hand_pose, correct) or run: it reads positions and writes poses.
std::string python_file(const HandProgram& program);

}  // namespace handsight
