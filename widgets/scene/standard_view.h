// SPDX-License-Identifier: GPL-3.0-or-later
// The views from which the robot is looked at by name.
#pragma once

namespace handsight::widgets {

enum class StandardView { front, back, left, right, top, camera, tcp, all };

}  // namespace handsight::widgets
