// SPDX-License-Identifier: Apache-2.0
// Measured poses as points, so that everything that works on markers works on them. A pose is shown by six points of
// the target, at a lever L behind and before its origin on each axis; of each only the coordinate along the next axis
// counts, +-x along y, +-y along z, +-z along x, divided by the root of 2. A shift t and a turn w move these six by
// (t_y +- L w_z), (t_z +- L w_x), (t_x +- L w_y), over the root of 2, whose squares add to |t|^2 + L^2 |w|^2: six
// independent measurements with the sigma of a place's coordinate where L is the ratio of the sigma of places to that
// of angles, and no more and no less than the pose.
#pragma once

#include "session/session.h"

namespace handsight {

constexpr int pose_markers = 6;
constexpr double usual_lever = 0.3;  // m: a pose sensor's sigma over its sigma_angle where they are not given

/// The six points of a target, in its frame (m): -x, +x, -y, +y, -z, +z, so that their body frame is the target's.
std::vector<Vector3> pose_shape(double lever);

/// The lever of the session's sigmas.
double pose_lever(const PoseSensor& sensor);

/// Gives the session of a pose sensor its markers: shape, count, noise of a coordinate and sightings.
void show_poses(Session& session, double lever);

/// Gives one observation of such a session its sightings; none where it has no pose.
void show_pose(Observation& observation, double lever);

/// What the coordinate of a point counts along, where the target is turned so (Sighting::along).
Vector3 measured_along(const Matrix3& target_rotation, int marker);

/// What six residuals of a pose (in order of marker, for this lever) say of its place (m) and its turn (rad), both in
/// the target's axes.
struct PoseError {
  Vector3 place, turn;
};
PoseError pose_error(const Eigen::Matrix<double, 6, 1>& residuals, double lever);

}  // namespace handsight
