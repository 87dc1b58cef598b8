// SPDX-License-Identifier: Apache-2.0
// Everything of a session but what was observed.
#pragma once

#include "session/session.h"

namespace handsight {

/// A copy with no observation, however many there are: none of them is copied on the way.
Session without_observations(const Session& session);

}  // namespace handsight
