// SPDX-License-Identifier: Apache-2.0
// By what noise the sensors of several sessions count beside each other.
#pragma once

#include <vector>

#include "session/joined.h"

namespace handsight {

/// Sets JoinedMember::noise where a session does not declare its sensor's, from a fit of it alone, so that the sessions
/// can be joined: where one declares what others do not, where sensors are of different kinds, or where the noise that
/// is seen differs by more than a quarter. A single member, and sensors of one kind that are alike, need none.
void learn_noise(std::vector<JoinedMember>& members);

}  // namespace handsight
