// SPDX-License-Identifier: Apache-2.0
// Which joint another one turns with (joint_coupling): counted along the chain.
#pragma once

#include <optional>

#include "effects/effect.h"

namespace handsight {

/// The moving joint that stands `before` places nearer to the root than `joint` (an index into robot.joints) on the
/// chain's way to the TCP, or to the sensor's link where the joint is not on the first; negative: farther from it.
/// Nothing where there is none, for 0, and where one of the two follows the other already (a mimic joint).
std::optional<int> coupled_joint(const Chain& chain, int joint, int before);

/// The joint that a term of joint_coupling turns its own joint with; nothing of other effects.
std::optional<int> coupled_joint(const Chain& chain, const EffectTerm& term);

}  // namespace handsight
