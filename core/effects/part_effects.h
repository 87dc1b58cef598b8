// SPDX-License-Identifier: Apache-2.0
// What each of several sessions that are fitted as one has for itself: slips, drifts, time lags, a payload, cameras.
#pragma once

#include <utility>

#include "effects/effect.h"

namespace handsight {

/// Of a joined session: the catalogue's effects that are not the robot's, at each of its parts, in place of those of
/// the whole session. A mount that several parts share has one camera_mount, a body that they share one payload. And
/// what may have changed from session to session: joint_offset_changed at every joint of every part but the first, and
/// the same of other effects of joints where a part has them for its own. Empty where the chain is that of a session by
/// itself. InputError where a part's own effect is none of joints.
OwnEffects part_effects(const Chain& chain);

/// What the parts have for their own by their description (SessionPart::own), all numbers 0, to be estimated: terms of
/// `effects`, which are part_effects. InputError where one names no joint that matters.
std::vector<EffectTerm> own_terms(const Chain& chain, const OwnEffects& effects);

/// The effects of a joined session's cameras, each by itself; the first camera of each rig (`firsts`, ascending) cannot
/// move in it. Of a single rig these are rig_effects.
OwnEffects rig_effects_of_parts(const Rig& cameras, const std::vector<int>& firsts);

/// Effects with one id, each of the body of one part (its index), as one effect at these parts: it acts on that body's
/// markers, as if there were no others.
Effect at_bodies(const std::vector<std::pair<int, Effect>>& of_parts, const Chain& chain);

}  // namespace handsight
