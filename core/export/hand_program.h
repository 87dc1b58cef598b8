// SPDX-License-Identifier: Apache-2.0
// The corrected hand pose as a small program: rigid bodies on joints, and what the effects add to them as formulas.
// cpp_file.h and python_file.h write it down; it gives what predict_tcp gives.
#pragma once

#include "correct/calibrated_robot.h"
#include "export/program_types.h"

namespace handsight {

/// InputError where an effect of the model cannot be written down.
HandProgram hand_program(const CalibratedRobot& robot);

}  // namespace handsight
