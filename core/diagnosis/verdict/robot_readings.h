// SPDX-License-Identifier: Apache-2.0
// What a person with a ruler would read at the real robot, in one posture with these effects at work. Nothing where the
// springs are too soft for the load. Internal to robot_check.cpp.
#pragma once

#include <optional>

#include "effects/effect.h"

namespace handsight {

using Terms = std::vector<EffectTerm>;
using ReadValue = std::optional<Eigen::VectorXd>;  // one number, or the coordinates of something

/// The same posture, held still.
ObservationState at_rest(ObservationState states);

/// m: how far the hand drops once 1 kg hangs on it.
ReadValue drop(const ObservationState& states, const Terms& terms);

/// m, root frame: the hand with every play and friction on one of its two sides, less the other.
ReadValue between_sides(const ObservationState& states, const Terms& terms);

/// m, sensor frame: where the hand is.
ReadValue hand_in_sensor(const ObservationState& states, const Terms& terms, const Rigid& mount);

/// m, sensor frame: the hand in this posture when the session ends, less when it starts.
ReadValue from_start_to_end(const ObservationState& states, const Terms& terms, const Rigid& mount);

/// rad (m): how much more the joint has than it reads, at the reading q.
double angle_error(const ObservationState& states, const Terms& terms, int joint, double q);

/// px: how far the image points of x (m, first camera) in `rig` miss the epipolar lines of `nominal`, by each camera
/// but the first with the first.
ReadValue off_epipolar_line(const Rig& nominal, const Rig& rig, const Vector3& x);

/// px: the image points of x (m, first camera) in all cameras.
ReadValue image_points(const Rig& rig, const Vector3& x);

}  // namespace handsight
