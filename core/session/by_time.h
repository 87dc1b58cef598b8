// SPDX-License-Identifier: Apache-2.0
// The order in which observations were taken.
#pragma once

#include <vector>

#include "session/session.h"

namespace handsight {

/// Indices into Session::observations in order of time, then id, whatever their order in memory.
std::vector<int> by_time(const Session& session);

}  // namespace handsight
