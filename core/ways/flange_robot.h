// SPDX-License-Identifier: Apache-2.0
// A made-up robot for where none is known but the pose of its flange: three slides and three turns.
#pragma once

#include <string>

#include "ways/series.h"

namespace handsight {

/// Links "base" ... "flange"; joints flange_x, flange_y, flange_z (m), flange_yaw, flange_pitch, flange_roll (rad): the
/// flange stands at that place with R = Rz(yaw) Ry(pitch) Rx(roll).
std::string flange_robot_urdf();

/// The joints' values for these poses of the flange.
JointSeries flange_joints(const PoseSeries& base_from_flange);

}  // namespace handsight
