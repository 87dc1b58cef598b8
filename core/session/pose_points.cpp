// SPDX-License-Identifier: Apache-2.0
#include "session/pose_points.h"

#include <cmath>

namespace handsight {
namespace {

constexpr double exactly_known = 1e-3;  // of the noise: a target's own points do not move against each other

int axis_of(int marker) { return marker / 2; }
double side_of(int marker) { return marker % 2 == 0 ? -1 : 1; }

}  // namespace

Vector3 measured_along(const Matrix3& target_rotation, int marker) {
  return target_rotation.col((axis_of(marker) + 1) % 3) / std::sqrt(2.0);
}

std::vector<Vector3> pose_shape(double lever) {
  std::vector<Vector3> points;
  for (int m = 0; m < pose_markers; ++m) points.push_back(side_of(m) * lever * Vector3::Unit(axis_of(m)));
  return points;
}

double pose_lever(const PoseSensor& sensor) {
  return sensor.sigma && sensor.sigma_angle ? *sensor.sigma / *sensor.sigma_angle : usual_lever;
}

void show_pose(Observation& o, double lever) {
  o.sightings.clear();
  if (!o.target_pose) return;
  const std::vector<Vector3> shape = pose_shape(lever);
  for (int m = 0; m < pose_markers; ++m) {
    Sighting& s = o.sightings.emplace_back();
    s.marker = m;
    s.point = *o.target_pose * shape[static_cast<std::size_t>(m)];
    s.along = measured_along(o.target_pose->rotation, m);
  }
}

void show_poses(Session& session, double lever) {
  const bool is_reported = session.pose_sensor->sigma && session.pose_sensor->sigma_angle;
  session.marker_count = pose_markers;
  session.sigma_point = is_reported ? session.pose_sensor->sigma : std::nullopt;
  session.shape = KnownShape{pose_shape(lever), exactly_known * session.sigma_point.value_or(1e-4)};
  for (Observation& o : session.observations) show_pose(o, lever);
}

PoseError pose_error(const Eigen::Matrix<double, 6, 1>& residuals, double lever) {
  PoseError error;
  for (int axis = 0; axis < 3; ++axis) {
    const int moved = (axis + 1) % 3, turned = (axis + 2) % 3;
    error.place[moved] = (residuals[2 * axis] + residuals[2 * axis + 1]) / std::sqrt(2.0);
    error.turn[turned] = (residuals[2 * axis + 1] - residuals[2 * axis]) / (std::sqrt(2.0) * lever);
  }
  return error;
}

}  // namespace handsight
