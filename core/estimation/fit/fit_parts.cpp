// SPDX-License-Identifier: Apache-2.0
#include "estimation/fit/fit_parts.h"

#include <algorithm>

#include "base/error.h"
#include "chain/unknown_angle.h"
#include "estimation/fit/touch_counts.h"
#include "estimation/fit/touch_unknown.h"
#include "session/joined.h"

namespace handsight {
namespace {

/// Where a body's markers begin and end among all.
struct Range {
  std::size_t first = 0, end = 0;
};

Range markers_of_body(const Problem& problem, int body) {
  const std::vector<Chain>& parts = problem.source->chain.parts;
  Range range{0, static_cast<std::size_t>(problem.marker_count)};
  for (const Chain& part : parts)
    if (part.body == body) range.first = static_cast<std::size_t>(part.first_marker);
  for (const Chain& part : parts)
    if (static_cast<std::size_t>(part.first_marker) > range.first)
      range.end = std::min(range.end, static_cast<std::size_t>(part.first_marker));
  return range;
}

std::vector<std::optional<Vector3>> seen_markers(const Problem& problem, const std::vector<Vector3>& markers,
                                                 const Range& range) {
  std::vector<std::optional<Vector3>> seen(markers.size());
  for (std::size_t m = range.first; m < range.end; ++m)
    if (problem.marker_is_seen[m]) seen[m] = markers[m];
  return seen;
}

int body_count(const Problem& problem) {
  int count = 1;
  for (const Chain& part : problem.source->chain.parts) count = std::max(count, part.body + 1);
  return count;
}

/// Are the markers of a body one piece of known shape?
bool is_of_known_shape(const Problem& problem, const Range& range) {
  if (!problem.has_shape_prior() || range.end == range.first) return false;
  return problem.shape->piece(range.first) == problem.shape->piece(range.end - 1);
}

FitPart take_part(const Fit& fit, const SessionPart& from) {
  const Problem& p = fit.problem;
  const Unknowns& u = estimate(fit);
  FitPart part;
  part.mount_from_sensor = u.mount(from.mount);
  if (const Eigen::Index column = p.column_of_mount(from.mount); column >= 0)
    part.mount_covariance = fit.parameter_covariance.block<6, 6>(column, column);
  const BodySides sides = from.body == 0 ? fit.sides : sides_of_body(p, u.markers_in_tcp, from.body);
  if (sides.markers.empty()) return part;
  const BodyFrame frame = body_frame(sides, u.markers_in_tcp);
  part.tcp_from_body = frame.tcp_from_body;
  part.rotation_is_observed = frame.unobserved.cols() == 0;
  const Eigen::Index markers = 3 * p.marker_count;
  part.covariance = body_covariance(frame, fit.parameter_covariance.topLeftCorner(markers, markers));
  for (int m = from.first_marker; m < from.first_marker + from.marker_count; ++m)
    part.markers_in_body.push_back(inverse(frame.tcp_from_body) * u.markers_in_tcp[static_cast<std::size_t>(m)]);
  return part;
}

/// Of the numbers of a fixture's small motion that mean nothing (a plane's turn about its normal) nothing is known.
void forget_meaningless(const FixtureKind& kind, Matrix6& covariance) {
  const std::vector<Eigen::Index> meant = list_numbers(kind);
  for (Eigen::Index n = 0; n < 6; ++n)
    if (std::find(meant.begin(), meant.end(), n) == meant.end())
      covariance(n, n) = n < 3 ? unknown_length * unknown_length : unknown_angle_variance;
}

/// Where the fixtures of the sessions of touches are, and the tips, each body by itself.
void start_of_touches(const Session& joined, const std::function<Fit(const Session& part)>& fit_alone,
                      Unknowns& start) {
  std::vector<int> done;
  for (const SessionPart& part : joined.parts) {
    if (part.fixture < 0 || std::find(done.begin(), done.end(), part.body) != done.end()) continue;
    done.push_back(part.body);
    const std::optional<Session> touches = touches_of_body(joined, part.body);
    const Fit alone = fit_alone(*touches);
    for (int m = 0; m < part.marker_count; ++m)
      start.markers_in_tcp[static_cast<std::size_t>(part.first_marker + m)] =
          estimate(alone).markers_in_tcp[static_cast<std::size_t>(m)];
    int next = 0;
    for (const SessionPart& other : joined.parts)
      if (other.fixture >= 0 && other.body == part.body) start.mount(other.mount) = estimate(alone).mount(next++);
  }
}

}  // namespace

Unknowns start_of_parts(const Session& joined, const Problem& problem,
                        const std::function<Fit(const Session& part)>& fit_alone) {
  Unknowns start;
  start.markers_in_tcp.assign(static_cast<std::size_t>(problem.marker_count), Vector3::Zero());
  start.other_mounts.resize(joined.other_mounts.size());
  start.effects = effect_values(problem);
  std::vector<char> has_mount(joined.other_mounts.size() + 1, 0), has_body(joined.parts.size(), 0);
  for (std::size_t p = 0; p < joined.parts.size(); ++p) {
    const SessionPart& part = joined.parts[p];
    if (part.fixture >= 0) continue;
    char &mount_is_known = has_mount[static_cast<std::size_t>(part.mount)],
         &body_is_known = has_body[static_cast<std::size_t>(part.body)];
    if (mount_is_known && body_is_known) continue;
    try {
      const Fit alone = fit_alone(part_session(joined, static_cast<int>(p)));
      if (!mount_is_known) start.mount(part.mount) = estimate(alone).mount_from_sensor;
      for (int m = 0; !body_is_known && m < part.marker_count; ++m)
        start.markers_in_tcp[static_cast<std::size_t>(part.first_marker + m)] =
            estimate(alone).markers_in_tcp[static_cast<std::size_t>(m)];
    } catch (const InputError& e) {
      throw InputError(message("session \"{}\" of {}: {}", part.title, joined.title, e.sentence()));
    }
    mount_is_known = body_is_known = 1;
  }
  start_of_touches(joined, fit_alone, start);
  return start;
}

std::vector<FitPart> list_parts(const Session& session, const Fit& fit) {
  std::vector<FitPart> parts;
  const std::vector<char> are_untold = undetermined_fixtures(session, fit);
  for (const SessionPart& part : session.parts) {
    parts.push_back(take_part(fit, part));
    if (part.fixture < 0) continue;
    FitPart& found = parts.back();
    found.place_is_determined = !are_untold[static_cast<std::size_t>(part.fixture)];
    if (found.mount_covariance)
      forget_meaningless(*session.fixtures[static_cast<std::size_t>(part.fixture)].kind, *found.mount_covariance);
  }
  return parts;
}

bool set_slip_frames(Problem& problem, const std::vector<Vector3>& markers) {
  constexpr double still = 1e-10;
  bool moved = false;
  problem.other_slip_frames.resize(static_cast<std::size_t>(body_count(problem) - 1));
  for (int body = 1; body < body_count(problem); ++body) {
    const BodySides sides = sides_of_body(problem, markers, body);
    if (sides.markers.empty()) continue;
    Rigid& frame = problem.other_slip_frames[static_cast<std::size_t>(body - 1)];
    const Rigid now = body_frame(sides, markers).tcp_from_body;
    moved = moved || small_motion_between(frame, now).norm() > still;
    frame = now;
  }
  return moved;
}

BodySides sides_of_body(const Problem& problem, const std::vector<Vector3>& markers, int body) {
  const Range range = markers_of_body(problem, body);
  if (!is_of_known_shape(problem, range)) return choose_sides(seen_markers(problem, markers, range));
  std::vector<std::optional<Vector3>> described(markers.size());
  for (std::size_t m = range.first; m < range.end; ++m) described[m] = problem.shape->markers[m];
  return choose_sides(described);
}

}  // namespace handsight
