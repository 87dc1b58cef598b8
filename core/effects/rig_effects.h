// SPDX-License-Identifier: Apache-2.0
// The effects of a rig's cameras. For two of them one effect moves both, its parameters named after the camera
// (`left_fx`); of more cameras, or of one, each has an effect of its own: with eight, one effect on all would have so
// many numbers that nobody's fault could be shown.
#pragma once

#include "effects/effect.h"

namespace handsight {

/// What stands in place of the catalogue's effects, which are those of the cameras `left` and `right`: none for these.
OwnEffects rig_effects(const Rig& rig);

/// Gives an effect the camera_numbers from `first` on, `count` of them: of both cameras of a pair, with their names
/// before those of the numbers, or of a single camera of any other rig.
Effect with_camera_numbers(Effect effect, const Rig& rig, int first, int count);

Effect rig_motions(const Rig& rig);
Effect camera_intrinsics(const Rig& rig);
Effect lens_distortion(const Rig& rig);

}  // namespace handsight
