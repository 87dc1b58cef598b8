// SPDX-License-Identifier: Apache-2.0
// The effects of a printed target, made for the target of a session: they need to know where its points are described
// to lie, or how far away a pose sensor saw it.
#pragma once

#include "effects/effect.h"

namespace handsight {

/// What stands in place of the catalogue's target_scale, target_bend and tag_placement, where the session knows the
/// shape of its markers, all of one piece, and holds it or takes it for known within a sigma; a bend only of a flat
/// target, a placement only of a body of two tags or more. A pose
/// sensor's target has a scale alone: all distances that it measured are wrong by the same share.
OwnEffects target_effects(const Session& session, const Chain& chain);

/// The move of the catalogue's own: of no target. Nothing of the robot moves, so that predictions need no target.
void move_no_target(const ObservationState&, int place, std::span<const double> values, Sites& sites);

/// Is it one of these, which no session has given its target?
bool has_no_target(const Effect& effect);

/// Where a known shape of one piece has its markers (m), in the body frame that follows from them.
std::vector<Vector3> described_in_body(const KnownShape& shape);

/// The motion into that frame from the one in which the shape is described.
Rigid body_from_described(const KnownShape& shape);

/// target_scale, moving these points of a body (m, body frame) away from its origin.
Effect target_scale(std::vector<Vector3> in_body);

/// target_scale of a target that a pose sensor saw at these places (m, sensor frame), by the order of the observation.
Effect target_scale_of_poses(std::vector<Vector3> in_sensor_by_order);

/// target_bend of a flat target: where its points are (m), in its own frame, z across it.
Effect target_bend(const KnownShape& shape);

/// tag_placement of a body of tags at known places: target_from_tag * exp(v) in place of target_from_tag.
Effect tag_placement(const Target& target);

}  // namespace handsight
