// SPDX-License-Identifier: Apache-2.0
#include "estimation/problem/pose_residuals.h"

#include <algorithm>
#include <cmath>
#include <numbers>

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

namespace {

/// Root mean squares of the lengths, over the observations of a pose sensor; zero where there are none.
struct PoseErrorSizes {
  double place = 0, turn = 0;  // m, rad
};

PoseErrorSizes find_sizes(const Problem& problem, const Unknowns& unknowns) {
  PoseErrorSizes sum;
  double count = 0;
  for (const ProblemObservation& o : problem.observations)
    if (const auto error = pose_residual(problem, o, unknowns)) {
      sum.place += error->place.squaredNorm();
      sum.turn += error->turn.squaredNorm();
      ++count;
    }
  if (count == 0) return {};
  return {std::sqrt(sum.place / count), std::sqrt(sum.turn / count)};
}

}  // namespace

double seen_lever(const Problem& problem, const Unknowns& unknowns) {
  const PoseErrorSizes sizes = find_sizes(problem, unknowns);
  if (!(sizes.place > 0) || !(sizes.turn > 0)) return usual_lever;
  return std::clamp(sizes.place / sizes.turn, 1e-3, 1e3);
}

Message turn_misfit_text(const Problem& problem, const Unknowns& unknowns) {
  constexpr double many = 0.1;        // rad: of tags that are seen badly, some degrees
  constexpr double far_better = 0.1;  // places against turns, at the usual lever
  const PoseErrorSizes sizes = find_sizes(problem, unknowns);
  if (!(sizes.turn > many) || sizes.place > far_better * usual_lever * sizes.turn) return {};
  return message(
      "The target's places agree to {:.2g} mm and its turns only to {:.2g} degrees: either the sensor tells no turns, "
      "or "
      "they are read otherwise than they were written (order of a quaternion, kind of angles). The places alone carry "
      "this answer.",
      1e3 * sizes.place, sizes.turn * 180 / std::numbers::pi);
}

Session shown_as_fitted(const Session& session, const Unknowns& unknowns) {
  Session shown = session;
  const auto& markers = unknowns.markers_in_tcp;
  if (has_unknown_lever(session) && markers.size() == pose_markers)
    show_poses(shown, 0.5 * (markers[1] - markers[0]).norm());
  return shown;
}

}  // namespace handsight
