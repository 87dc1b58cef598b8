// SPDX-License-Identifier: Apache-2.0
// Poses of a target that do not go with the others, up to half of them. Internal to blunders.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "blunders/blunder.h"
#include "session/session.h"

namespace handsight {

/// The ids of observations whose poses do not go with those of the others, clearly and by consensus; empty: there are
/// none, or no six others that agree.
std::vector<std::int64_t> stray_poses(const Session& session);

/// The mistake that these are, where without them the fit leaves a small part of `before` (m).
std::optional<Blunder> find_stray_poses(const Session& session, double before);

}  // namespace handsight
