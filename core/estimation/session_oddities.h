// SPDX-License-Identifier: Apache-2.0
// What a session says that is possible but hardly meant: units, swapped numbers, copies.
#pragma once

#include <string>
#include <vector>

#include "session/session.h"

namespace handsight {

/// A sentence each: positions that look like degrees, cameras that see nothing or everything, a left image that is the
/// right one, poses that are all one pose, gravity of another planet.
std::vector<std::string> session_oddities(const Session& session);

}  // namespace handsight
