// SPDX-License-Identifier: Apache-2.0
// Where the marker body is in the sensor's frame, from one observation alone (thesis 4.24).
#pragma once

#include "camera/rig.h"
#include "geometry/rigid.h"
#include "session/session.h"

namespace handsight {

struct BodyPose {
  Rigid sensor_from_body;
  Matrix6 unit_covariance;  // of the small motion xi in exp(xi) sensor_from_body, for noise of 1 px (1 m)
  double cost = 0;          // squared residual, px^2 or m^2
  int rows = 0;
};

/// Least reprojection error over the sightings of markers with the given positions in the body frame (m); `guess`
/// is where to start. Nothing where the sightings do not determine the six unknowns (fewer than three markers, or
/// all on a line) or where it does not converge.
std::optional<BodyPose> estimate_body_pose(const Rig* rig, const std::vector<Sighting>& sightings,
                                           const std::vector<Vector3>& markers_in_body, const Rigid& guess);

/// The pose alone, near enough to the least reprojection error to linearise there: within about `near_enough` (m, rad).
std::optional<Rigid> refined_body_pose(const Rig* rig, const std::vector<Sighting>& sightings,
                                       const std::vector<Vector3>& markers_in_body, const Rigid& guess,
                                       double near_enough);

/// A start without a guess, from three or more points that two cameras (or the tracker) saw.
std::optional<Rigid> body_pose_from_points(const Rig* rig, const std::vector<Sighting>& sightings,
                                           const std::vector<Vector3>& markers_in_body);

}  // namespace handsight
