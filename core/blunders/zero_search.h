// SPDX-License-Identifier: Apache-2.0
// The zero of one joint, anywhere on its circle.
#pragma once

#include <string>

#include "session/session.h"

namespace handsight {

/// What has to be added to the joint's readings (rad or m) for motions and points (seen_points.h) to go together best;
/// a multiple of 90 degrees where it is one within what a robot's zeros are off anyway.
double find_zero(const Session& points, const std::string& joint);

}  // namespace handsight
