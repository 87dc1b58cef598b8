// SPDX-License-Identifier: Apache-2.0
// The smallest change after which the rest of an observation agrees.
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "base/shown_number.h"
#include "chain/sighting.h"
#include "diagnosis/attribution/error_attribution.h"
#include "estimation/problem/body_pose.h"

namespace handsight {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// The body's own pose without some of the points, and how well the rest then agrees.
struct Rest {
  double squares_per_degree = never;
  Rigid sensor_from_body;
};

Rest rest_of(const Problem& problem, const std::vector<Vector3>& markers, const Rigid& guess,
             std::vector<Sighting> sightings) {
  std::erase_if(sightings, [](const Sighting& s) { return row_count(s) == 0; });
  const auto pose = estimate_body_pose(problem.rig_or_null(), sightings, markers, guess);
  if (!pose || pose->rows <= 6) return {};
  return {pose->cost / (pose->rows - 6), pose->sensor_from_body};
}

/// The corner without which the rest agrees best.
SingleChange best_corner(const Problem& problem, const ProblemObservation& o, const Unknowns& u, double& squares) {
  SingleChange best;
  squares = never;
  const Rigid guess = sensor_from_tcp_at(o, u);
  const std::vector<Vector3> markers = markers_at(o, u);
  for (std::size_t i = 0; i < o.sightings.size(); ++i)
    for (const auto& [camera, measured, sigma] : o.sightings[i].in_cameras) {
      std::vector<Sighting> others = o.sightings;
      forget(others[i], camera);
      const Rest rest = rest_of(problem, markers, guess, others);
      if (rest.squares_per_degree >= squares) continue;
      squares = rest.squares_per_degree;
      const Vector3 x = rest.sensor_from_body * markers[static_cast<std::size_t>(o.sightings[i].marker)];
      const RigCamera& c = problem.rig->at(camera);
      const Vector2 expected = project(c.camera, Vector3(c.camera_from_first * x));
      best = {SingleChange::Kind::corner,
              o.sightings[i].marker,
              camera,
              expected - measured,
              Vector3::Zero(),
              (expected - measured).norm(),
              0};
    }
  return best;
}

/// The marker without which the rest agrees best: moved on the body, hidden in part, or another corner in both images.
SingleChange best_marker(const Problem& problem, const ProblemObservation& o, const Unknowns& u, double& squares) {
  SingleChange best;
  squares = never;
  const Rigid guess = sensor_from_tcp_at(o, u);
  const std::vector<Vector3> markers = markers_at(o, u);
  for (std::size_t i = 0; i < o.sightings.size(); ++i) {
    const Sighting& s = o.sightings[i];
    std::vector<Sighting> others = o.sightings;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    const Rest rest = rest_of(problem, markers, guess, others);
    if (rest.squares_per_degree >= squares) continue;
    std::optional<Vector3> seen = s.point;
    if (!seen && problem.rig)
      if (const auto point = triangulate_unweighed(*problem.rig, s)) seen = point->point;
    if (!seen) continue;
    squares = rest.squares_per_degree;
    const Vector3 in_body = inverse(rest.sensor_from_body) * *seen;
    const Vector3 offset = in_body - markers[static_cast<std::size_t>(s.marker)];
    best = {SingleChange::Kind::marker, s.marker, 0, Vector2::Zero(), offset, offset.norm(), 0};
  }
  return best;
}

Message direction(const Vector2& d) {
  const bool sideways = std::abs(d.x()) >= std::abs(d.y());
  const char* way = sideways ? (d.x() > 0 ? "right" : "left") : (d.y() > 0 ? "down" : "up");
  return message("{:.1f} px further {}", sideways ? std::abs(d.x()) : std::abs(d.y()), way);
}

}  // namespace

SingleChange single_change(const Problem& problem, const ProblemObservation& o, const Unknowns& u, double noise,
                           const TypicalParts& typical, const ResidualParts& parts, ErrorCause cause) {
  SingleChange change;
  if (cause == ErrorCause::none) return change;
  const Rigid sensor_from_tcp = sensor_from_tcp_at(o, u);
  if (cause == ErrorCause::robot) {
    if (!parts.sensor_from_body) return change;
    const Rigid motion = inverse(sensor_from_tcp) * *parts.sensor_from_body;
    change.kind = SingleChange::Kind::pose;
    change.size = motion.translation.norm();
    change.angle = vector_from_rotation(motion.rotation).norm();
    return change;
  }
  // The rest agrees where it is no worse than three times what it usually is.
  const double usual = std::max(noise, typical.body);
  double squares = never;
  if (problem.rig) {
    SingleChange corner = best_corner(problem, o, u, squares);
    if (squares < 9 * usual * usual) return corner;
  }
  SingleChange marker = best_marker(problem, o, u, squares);
  if (squares < 9 * usual * usual) return marker;
  const bool images = cause == ErrorCause::cameras;
  change.kind = images ? SingleChange::Kind::images : SingleChange::Kind::body;
  change.size = images ? rms(parts.cameras, parts.camera_rows) : rms(parts.body, parts.body_rows);
  return change;
}

Message change_text(const SingleChange& c, const Rig* rig) {
  const bool in_pixels = rig != nullptr;
  constexpr double degrees = 57.29577951308232;
  switch (c.kind) {
    case SingleChange::Kind::none:
      return {};
    case SingleChange::Kind::corner:
      return message("Marker {}, {} image, {}.", c.marker, rig->at(c.camera).name, direction(c.shift));
    case SingleChange::Kind::marker:
      return message("Marker {}, {} mm from its place on the body: loose, hidden in part, or another corner.", c.marker,
                     number(shown_number(1e3 * c.size)));
    case SingleChange::Kind::images:
      return message(
          "The {} images do not fit together ({} px across the epipolar lines): not taken at the same instant, or "
          "several wrong corners.",
          is_pair(*rig) ? "two" : "cameras'", number(shown_number(c.size)));
    case SingleChange::Kind::body:
      return message(
          "The markers do not lie to each other as on the other images ({} {}): several are wrong, or the body is "
          "bent.",
          number(shown_number(c.size * (in_pixels ? 1 : 1e3))), in_pixels ? "px" : "mm");
    case SingleChange::Kind::pose:
      return message("The whole hand, {} mm and {} deg from where the robot says.", number(shown_number(1e3 * c.size)),
                     number(shown_number(degrees * c.angle)));
  }
  return {};
}

}  // namespace handsight
