// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/attribution/error_attribution.h"

#include <algorithm>
#include <cmath>

#include "base/median.h"
#include "chain/sighting.h"
#include "estimation/fit/noise.h"
#include "estimation/problem/body_pose.h"

namespace handsight {
namespace {

constexpr double beyond = 4;  // times what is typical: an observation's own fault

bool exceeds(double squares, int rows, double noise) {
  return rows > 0 && noise > 0 && chi_squared_tail(squares / (noise * noise), rows) < least_likely_noise;
}

double median_of(std::vector<double> values) {
  constexpr std::size_t fewest = 5;
  return values.size() < fewest ? 0 : median(std::move(values));
}

ErrorAttribution shares(double cameras, double body, double robot) {
  ErrorAttribution attribution;
  const double sum = cameras + body + robot;
  if (!(sum > 0)) return attribution;
  attribution.cameras = cameras / sum;
  attribution.body = body / sum;
  attribution.robot = robot / sum;
  return attribution;
}

}  // namespace

std::string_view error_cause_name(ErrorCause cause) {
  switch (cause) {
    case ErrorCause::none:
      return "";
    case ErrorCause::cameras:
      return "cameras";
    case ErrorCause::body:
      return "body";
    case ErrorCause::robot:
      return "robot";
  }
  return "";
}

ResidualParts residual_parts(const Problem& problem, const ProblemObservation& o, const Unknowns& u) {
  ResidualParts parts;
  const Rig* rig = problem.rig_or_null();
  const Rigid sensor_from_tcp = sensor_from_tcp_at(o, u);
  for (const Sighting& s : o.sightings) {
    const SightingNormal normal = sighting_normal(rig, s, sensor_from_tcp * marker_at(o, u, s.marker));
    parts.total += normal.cost;
    parts.rows += normal.rows;
    if (!rig) continue;
    if (const auto point = triangulate_unweighed(*rig, s)) {
      parts.cameras += sighting_normal(rig, s, point->point).cost;
      parts.camera_rows += normal.rows - 3;
    }
  }
  const auto pose = estimate_body_pose(rig, o.sightings, markers_at(o, u), sensor_from_tcp);
  if (!pose) return parts;
  parts.sensor_from_body = pose->sensor_from_body;
  parts.body = std::max(0.0, pose->cost - parts.cameras);
  parts.body_rows = std::max(0, parts.rows - 6 - parts.camera_rows);
  parts.robot = std::max(0.0, parts.total - pose->cost);
  parts.robot_rows = 6;
  return parts;
}

TypicalParts typical_parts(const std::vector<ResidualParts>& used) {
  std::vector<double> cameras, body;
  for (const ResidualParts& p : used) {
    if (p.camera_rows > 0) cameras.push_back(rms(p.cameras, p.camera_rows));
    if (p.body_rows > 0) body.push_back(rms(p.body, p.body_rows));
  }
  return {median_of(cameras), median_of(body)};
}

ErrorAttribution attribute_error(const ResidualParts& parts, double noise, const TypicalParts& typical) {
  const auto excess = [&](double squares, int rows) { return std::max(0.0, squares - rows * noise * noise); };
  ErrorCause cause = ErrorCause::none;
  // From the inside out: images that do not fit together spoil the body's shape too, and a body out of shape its pose.
  if (exceeds(parts.cameras, parts.camera_rows, noise) &&
      rms(parts.cameras, parts.camera_rows) > beyond * typical.cameras) {
    cause = ErrorCause::cameras;
  } else if (exceeds(parts.body, parts.body_rows, noise) && rms(parts.body, parts.body_rows) > beyond * typical.body) {
    cause = ErrorCause::body;
  } else if (exceeds(parts.robot, parts.robot_rows, noise)) {
    cause = ErrorCause::robot;
  }
  if (cause == ErrorCause::none) return {};
  ErrorAttribution attribution = shares(excess(parts.cameras, parts.camera_rows), excess(parts.body, parts.body_rows),
                                        excess(parts.robot, parts.robot_rows));
  attribution.cause = cause;
  return attribution;
}

ErrorAttribution attribute_error(const std::vector<ResidualParts>& used, double noise) {
  ResidualParts sum;
  for (const ResidualParts& p : used) {
    sum.cameras += p.cameras;
    sum.body += p.body;
    sum.robot += p.robot;
    sum.camera_rows += p.camera_rows;
    sum.body_rows += p.body_rows;
    sum.robot_rows += p.robot_rows;
  }
  const auto excess = [&](double squares, int rows) {
    return exceeds(squares, rows, noise) ? squares - rows * noise * noise : 0.0;
  };
  ErrorAttribution attribution =
      shares(excess(sum.cameras, sum.camera_rows), excess(sum.body, sum.body_rows), excess(sum.robot, sum.robot_rows));
  const double largest = std::max({attribution.cameras, attribution.body, attribution.robot});
  if (largest > 0)
    attribution.cause = largest == attribution.robot  ? ErrorCause::robot
                        : largest == attribution.body ? ErrorCause::body
                                                      : ErrorCause::cameras;
  return attribution;
}

std::vector<ObservationAttribution> attribute_observations(const Session& session, const Fit& fit) {
  std::vector<ObservationAttribution> list;
  if (!fit.noise || !(*fit.noise > 0)) return list;
  Problem problem = make_problem(session, make_chain(session), list_terms(fit));
  if (!problem.terms.empty()) {
    problem.copy_slip_frames(fit.problem);
    place_observations(problem);
  }
  const Unknowns& u = estimate(fit);
  std::vector<ResidualParts> parts;
  for (ProblemObservation& o : problem.observations) {
    std::erase_if(o.sightings,
                  [&](const Sighting& s) { return !fit.problem.marker_is_seen[static_cast<std::size_t>(s.marker)]; });
    parts.push_back(residual_parts(problem, o, u));
  }
  const TypicalParts typical = typical_parts(parts);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const ProblemObservation& o = problem.observations[i];
    ObservationAttribution b;
    b.index = o.index;
    b.id = session.observations[static_cast<std::size_t>(o.index)].id;
    b.parts = parts[i];
    b.attribution = attribute_error(parts[i], *fit.noise, typical);
    b.change = single_change(problem, o, u, *fit.noise, typical, parts[i], b.attribution.cause);
    b.smallest_visible = smallest_visible(problem, o, u, *fit.noise);
    list.push_back(b);
  }
  return list;
}

}  // namespace handsight
