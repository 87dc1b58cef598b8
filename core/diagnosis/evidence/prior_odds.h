// SPDX-License-Identifier: Apache-2.0
// The odds against what is rare, whatever the measurements say: slips, drifts, changes between sessions.
#pragma once

#include <optional>
#include <vector>

#include "effects/effect.h"

namespace handsight {

/// Slips are rare (one session in a thousand), and one that did not happen spoils the mount for good: ln of the prior
/// odds against one.
inline constexpr double ln_odds_against_slip = 7;
/// Cameras that drift are one in fifty.
inline constexpr double ln_odds_against_drift = 4;

/// A number of the robot changes from one session to the next in one of fifty.
inline constexpr double ln_odds_against_change = 4;

/// Is the term one session's own against the others (effects/part_effects.h)?
bool is_change_between_sessions(const EffectTerm& term);

/// Does the term explain by time alone: a slip, a drift?
bool follows_time(const EffectTerm& term);

/// ln of the odds against what is rare (a slip, a drift, a change between sessions): 0 for everything else.
double ln_odds_against(const EffectTerm& term);

/// The first moment from which on one of the terms acts (an observation's order); none where no term has one.
std::optional<double> slip_order(const std::vector<EffectTerm>& terms);

}  // namespace handsight
