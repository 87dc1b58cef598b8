// SPDX-License-Identifier: Apache-2.0
// The corrected hand pose as one C++17 file that needs the standard library alone.
#pragma once

#include <string>

#include "export/program_types.h"

namespace handsight {

/// To be included or compiled: handsight_hand::hand_pose, body_pose, nominal_hand_pose, correct. With
/// HANDSIGHT_HAND_MAIN it is a program that reads positions and writes poses.
std::string cpp_file(const HandProgram& program);

/// The lines that say what the file is of and what it leaves out, each after `mark`.
std::string program_comment(const HandProgram& program, const std::string& mark);

}  // namespace handsight
