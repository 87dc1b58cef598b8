// SPDX-License-Identifier: Apache-2.0
// What was seen and where the robot stood, each whole, in different orders. Internal to blunders.
#pragma once

#include <optional>

#include "blunders/blunder.h"
#include "session/session.h"

namespace handsight {

/// The mistake that this is, where the fit in the right order leaves a small part of `before` (px or m). Tried are
/// orders that programs make (files sorted as text: 1, 10, 11, 2; backwards), and, where poses are seen, the one that
/// motions tell (match_poses).
std::optional<Blunder> find_pairing_order(const Session& session, double before);

}  // namespace handsight
