// SPDX-License-Identifier: Apache-2.0
// A recorder that wrote an old reading again: the robot stood still while what was seen of it moved, or the other way.
#pragma once

#include <string>
#include <vector>

#include "base/message.h"
#include "session/session.h"

namespace handsight {

/// A sentence each way with the observations' numbers; empty where neither is. Neighbours in time count whose readings
/// are equal to the last digit while the others' changed by more than any noise (2 mm, 0.01 rad, 5 px).
std::vector<Message> standstill_warnings(const Session& session);

}  // namespace handsight
