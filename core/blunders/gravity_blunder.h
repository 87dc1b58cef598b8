// SPDX-License-Identifier: Apache-2.0
// Gravity that pulls along another axis than the session says.
#pragma once

#include <string>
#include <vector>

#include "session/session.h"

namespace handsight {

/// The axes of the root link along which gravity may pull in place of the declared one: "-z", "x", ...
std::vector<std::string> other_directions(const Session& session);

/// Has the robot declared springs and masses, so that gravity bends it?
bool feels_gravity(const Session& session);

}  // namespace handsight
