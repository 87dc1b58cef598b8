// SPDX-License-Identifier: Apache-2.0
// The error where the robot has not been measured decides what a change of a model is worth.
#pragma once

#include "diagnosis/verdict/diagnosis_result.h"

namespace handsight {

/// Is the error larger where the robot has not been measured? What time seems to explain where poses come region by
/// region, and what only bends to the poses at hand, shows there. Why a change is refused then; empty where it is not.
/// Works the regions' errors of `after` out.
std::string worse_elsewhere(const Diagnosis& before, Diagnosis& after);

}  // namespace handsight
