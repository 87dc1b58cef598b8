// SPDX-License-Identifier: Apache-2.0
#include "estimation/problem/pose_residuals.h"

#include <algorithm>
#include <cmath>

namespace handsight {

std::optional<PoseError> pose_residual(const Problem& problem, const ProblemObservation& o, const Unknowns& u) {
  if (!problem.shape || o.sightings.size() != pose_markers || !o.sightings.front().along) return std::nullopt;
  const Rigid sensor_from_tcp = sensor_from_tcp_at(o, u);
  Eigen::Matrix<double, pose_markers, 1> residuals;
  for (std::size_t m = 0; m < o.sightings.size(); ++m) {
    const Sighting& s = o.sightings[m];
    residuals[static_cast<Eigen::Index>(m)] = s.along->dot(*s.point - sensor_from_tcp * marker_at(o, u, s.marker));
  }
  return pose_error(residuals, problem.shape->markers.front().norm());
}

bool has_unknown_lever(const Session& session) {
  return session.pose_sensor && !(session.pose_sensor->sigma && session.pose_sensor->sigma_angle);
}

double seen_lever(const Problem& problem, const Unknowns& unknowns) {
  double places = 0, turns = 0;
  for (const ProblemObservation& o : problem.observations)
    if (const auto error = pose_residual(problem, o, unknowns)) {
      places += error->place.squaredNorm();
      turns += error->turn.squaredNorm();
    }
  if (!(places > 0) || !(turns > 0)) return usual_lever;
  return std::clamp(std::sqrt(places / turns), 1e-3, 1e3);
}

Session shown_as_fitted(const Session& session, const Unknowns& unknowns) {
  Session shown = session;
  const auto& markers = unknowns.markers_in_tcp;
  if (has_unknown_lever(session) && markers.size() == pose_markers)
    show_poses(shown, 0.5 * (markers[1] - markers[0]).norm());
  return shown;
}

}  // namespace handsight
