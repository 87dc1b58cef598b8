// SPDX-License-Identifier: GPL-3.0-or-later
// The drawings themselves, one function an effect, by where they act. Internal to effect_drawing*.cpp.
#pragma once

#include <map>
#include <string>

#include "widgets/drawings/drawing_kit.h"

namespace handsight::widgets {

using DrawEffect = void (*)(const DrawingKit& kit);

/// By effect id.
std::map<std::string, DrawEffect> joint_drawings();   // at one joint
std::map<std::string, DrawEffect> robot_drawings();   // base, load, coupled joints
std::map<std::string, DrawEffect> camera_drawings();  // cameras and time
std::map<std::string, DrawEffect> hand_drawings();    // the marker body; and "", the unnamed curve

}  // namespace handsight::widgets
