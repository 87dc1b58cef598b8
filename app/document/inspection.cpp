// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/inspection.h"

#include <QObject>
#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>

#include "estimation/body_pose.h"

namespace handsight::app {
namespace {

/// Squared residuals of one observation, split by what could take them up, and their degrees of freedom.
struct Parts {
  double cameras = 0, body = 0, robot = 0;
  int camera_rows = 0, body_rows = 0, robot_rows = 0;
};

/// What is left of a marker's four image coordinates when the marker may be anywhere.
double free_point_cost(const StereoRig& rig, const Sighting& s, MarkerResidual& marker, int& rows) {
  if (!s.left || !s.right) return 0;
  const auto point = triangulate(rig, *s.left, *s.right);
  if (!point) return 0;
  marker.measured_in_sensor = point->point;
  rows += 1;
  return sighting_normal(&rig, s, point->point).cost;
}

void predict(const StereoRig* rig, MarkerResidual& marker) {
  if (!rig) return;
  const Vector3& x = marker.predicted_in_sensor;
  const Vector3 in_right = rig->right_from_left * x;
  if (x.z() > 1e-6) marker.predicted_left = project(rig->left, x);
  if (in_right.z() > 1e-6) marker.predicted_right = project(rig->right, in_right);
}

void note_worst(const MarkerResidual& marker, InspectionRow& row) {
  const auto look = [&](double size, int camera) {
    if (size <= row.worst_size) return;
    row.worst_size = size;
    row.worst_marker = marker.marker;
    row.worst_camera = camera;
  };
  if (marker.left && marker.predicted_left) look((*marker.left - *marker.predicted_left).norm(), 0);
  if (marker.right && marker.predicted_right) look((*marker.right - *marker.predicted_right).norm(), 1);
  if (!marker.left && !marker.right && marker.measured_in_sensor)
    look((*marker.measured_in_sensor - marker.predicted_in_sensor).norm(), -1);
}

/// What the used observations show at the median, root mean square per degree of freedom.
struct Typical {
  double cameras = 0, body = 0;
};

Parts measure(const Problem& problem, const ProblemObservation& o, const Unknowns& unknowns, InspectionRow& row) {
  Parts parts;
  const StereoRig* rig = problem.rig_or_null();
  const Rigid sensor_from_tcp = sensor_from_tcp_at(o, unknowns.mount_from_sensor);
  double total = 0, lengths = 0;
  int points = 0;
  for (const Sighting& s : o.sightings) {
    MarkerResidual marker{.marker = s.marker, .left = s.left, .right = s.right};
    marker.predicted_in_sensor = sensor_from_tcp * marker_at(o, unknowns, s.marker);
    predict(rig, marker);
    if (rig) parts.cameras += free_point_cost(*rig, s, marker, parts.camera_rows);
    if (s.point) marker.measured_in_sensor = s.point;
    if (marker.measured_in_sensor) {
      lengths += (*marker.measured_in_sensor - marker.predicted_in_sensor).squaredNorm();
      ++points;
    }
    const SightingNormal normal = sighting_normal(rig, s, marker.predicted_in_sensor);
    total += normal.cost;
    row.coordinates += normal.rows;
    note_worst(marker, row);
    row.markers.push_back(std::move(marker));
  }
  if (row.coordinates > 0) row.rms = std::sqrt(total / row.coordinates);
  if (points > 0) row.rms_m = std::sqrt(lengths / points);
  const auto pose = estimate_body_pose(rig, o.sightings, markers_at(o, unknowns), sensor_from_tcp);
  if (!pose) return parts;
  row.tcp_from_tcp_est = inverse(sensor_from_tcp) * pose->sensor_from_body;
  row.angle = vector_from_rotation(row.tcp_from_tcp_est->rotation).norm();
  parts.body = std::max(0.0, pose->cost - parts.cameras);
  parts.body_rows = std::max(0, row.coordinates - 6 - parts.camera_rows);
  parts.robot = std::max(0.0, total - pose->cost);
  parts.robot_rows = 6;
  return parts;
}

bool exceeds(double cost, int rows, double noise) {
  if (rows <= 0 || noise <= 0) return false;
  const double squares = cost / (noise * noise);
  return boost::math::cdf(boost::math::complement(boost::math::chi_squared(rows), std::min(squares, 1e6))) < 1e-5;
}

double rms(double cost, int rows) { return rows > 0 ? std::sqrt(cost / rows) : 0; }

/// Of what exceeds the noise. The letter goes from the inside out: images that do not fit together spoil the body's
/// shape too, and a body out of shape spoils its pose. Where an effect is missing, the markers' estimate is bent and
/// every observation shows some of it: an observation is blamed on cameras or body only beyond what is typical.
Blame blame_of(const Parts& parts, double noise, const Typical& typical) {
  constexpr double beyond = 4;
  const auto excess = [&](double cost, int rows) { return std::max(0.0, cost - rows * noise * noise); };
  const double c = excess(parts.cameras, parts.camera_rows), b = excess(parts.body, parts.body_rows),
               r = excess(parts.robot, parts.robot_rows), sum = c + b + r;
  Blame blame;
  if (exceeds(parts.cameras, parts.camera_rows, noise) &&
      rms(parts.cameras, parts.camera_rows) > beyond * typical.cameras) {
    blame.letter = 'C';
  } else if (exceeds(parts.body, parts.body_rows, noise) && rms(parts.body, parts.body_rows) > beyond * typical.body) {
    blame.letter = 'B';
  } else if (exceeds(parts.robot, parts.robot_rows, noise)) {
    blame.letter = 'R';
  }
  if (sum > 0 && blame.letter != 0) {
    blame.cameras = c / sum;
    blame.body = b / sum;
    blame.robot = r / sum;
  }
  return blame;
}

QString direction(const Vector2& d) {
  const bool sideways = std::abs(d.x()) >= std::abs(d.y());
  const double size = sideways ? std::abs(d.x()) : std::abs(d.y());
  const QString way = sideways ? (d.x() > 0 ? QObject::tr("further right") : QObject::tr("further left"))
                               : (d.y() > 0 ? QObject::tr("further down") : QObject::tr("further up"));
  return QObject::tr("%1 px %2").arg(size, 0, 'f', 1).arg(way);
}

double cost_per_degree(const StereoRig* rig, const std::vector<Vector3>& markers, const Rigid& guess,
                       std::vector<Sighting> sightings) {
  std::erase_if(sightings, [](const Sighting& s) { return row_count(s) == 0; });
  const auto pose = estimate_body_pose(rig, sightings, markers, guess);
  return pose && pose->rows > 6 ? pose->cost / (pose->rows - 6) : std::numeric_limits<double>::infinity();
}

struct Corner {
  int marker = -1;
  bool left = true;
  Vector2 shift = Vector2::Zero();  // px, from measured to where the others say it is
  double cost = std::numeric_limits<double>::infinity();
};

/// The corner without which the rest agrees best, and where the rest would put it.
Corner best_single_corner(const Problem& problem, const ProblemObservation& o, const Unknowns& unknowns) {
  Corner best;
  const StereoRig* rig = problem.rig_or_null();
  const Rigid guess = sensor_from_tcp_at(o, unknowns.mount_from_sensor);
  const std::vector<Vector3> markers = markers_at(o, unknowns);
  for (std::size_t i = 0; i < o.sightings.size(); ++i)
    for (const bool left : {true, false}) {
      std::vector<Sighting> rest = o.sightings;
      std::optional<Vector2>& corner = left ? rest[i].left : rest[i].right;
      if (!corner) continue;
      const Vector2 measured = *corner;
      corner.reset();
      const double cost = cost_per_degree(rig, markers, guess, rest);
      if (cost >= best.cost) continue;
      std::erase_if(rest, [](const Sighting& s) { return row_count(s) == 0; });
      const auto pose = estimate_body_pose(rig, rest, markers, guess);
      const Vector3 x = pose->sensor_from_body * markers[static_cast<std::size_t>(o.sightings[i].marker)];
      const Vector2 expected = left ? project(rig->left, x) : project(rig->right, Vector3(rig->right_from_left * x));
      best = {o.sightings[i].marker, left, expected - measured, cost};
    }
  return best;
}

QString pose_sentence(const InspectionRow& row) {
  return QObject::tr("The whole hand, %1 mm and %2 deg from where the robot says.")
      .arg(1e3 * row.tcp_from_tcp_est->translation.norm(), 0, 'f', 1)
      .arg(57.29577951308232 * *row.angle, 0, 'f', 1);
}

/// The smallest change after which the rest agrees: one corner, one marker, the pose.
QString what_would_mend(const Problem& problem, const ProblemObservation& o, const Unknowns& unknowns, double noise,
                        const Parts& parts, const InspectionRow& row) {
  if (!row.tcp_from_tcp_est || row.blame.letter == 0) return {};
  if (row.blame.letter == 'R') return pose_sentence(row);
  if (problem.rig && row.blame.letter == 'C') {
    const Corner corner = best_single_corner(problem, o, unknowns);
    const bool others_agree = corner.marker >= 0 && corner.cost < 9 * noise * noise;
    if (others_agree)
      return QObject::tr("Marker %1, %2 image, %3.")
          .arg(corner.marker)
          .arg(corner.left ? QObject::tr("left") : QObject::tr("right"), direction(corner.shift));
    return QObject::tr(
               "The two images do not fit together (%1 px across the epipolar lines): not taken at the same "
               "instant, or several wrong corners.")
        .arg(std::sqrt(parts.cameras / std::max(1, parts.camera_rows)), 0, 'f', 1);
  }
  return QObject::tr(
             "The markers do not lie to each other as on the other images (%1 %2): one is loose, hidden in part, "
             "or another corner.")
      .arg(std::sqrt(parts.body / std::max(1, parts.body_rows)) * (problem.rig ? 1 : 1e3), 0, 'f', 1)
      .arg(problem.rig ? QObject::tr("px") : QObject::tr("mm"));
}

/// The session as if every observation that shows markers counted.
Session with_everything(const Session& session, const SecondLooks& looks) {
  Session all = session;
  all.source.reset();
  for (Observation& o : all.observations) {
    o.decision = Decision::none;
    if (const auto look = looks.find(o.id); look != looks.end() && o.sightings.empty()) o.sightings = look->second;
  }
  return all;
}

}  // namespace

namespace {

Parts measure_row(const Problem& problem, ProblemObservation& seen, const Unknowns& unknowns,
                  const std::vector<char>& marker_is_known, InspectionRow& row) {
  std::erase_if(seen.sightings,
                [&](const Sighting& s) { return !marker_is_known[static_cast<std::size_t>(s.marker)]; });
  row.root_from_tcp = seen.root_from_tcp;
  row.root_from_sensor = seen.root_from_mount * unknowns.mount_from_sensor * seen.sensor_motion;
  return measure(problem, seen, unknowns, row);
}

void judge(const Problem& problem, const ProblemObservation& seen, const Unknowns& unknowns,
           std::optional<double> noise, const Parts& parts, const Typical& typical, InspectionRow& row) {
  if (!noise || !row.rms || *noise <= 0) return;
  row.ratio = *row.rms / *noise;
  row.blame = blame_of(parts, *noise, typical);
  row.what_would_mend = what_would_mend(problem, seen, unknowns, std::max(*noise, typical.body), parts, row);
}

double median_of(std::vector<double> values) {
  if (values.size() < 5) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

void inspect_observation(const Problem& problem, const ProblemObservation& observation, const Unknowns& unknowns,
                         std::optional<double> noise, const std::vector<char>& marker_is_known, InspectionRow& row) {
  ProblemObservation seen = observation;
  const Parts parts = measure_row(problem, seen, unknowns, marker_is_known, row);
  judge(problem, seen, unknowns, noise, parts, {}, row);
}

Inspection inspect(const Session& session, const Fit& fit, const FitReport& report, const SecondLooks& looks) {
  Inspection inspection;
  inspection.noise = fit.noise;
  inspection.in_pixels = session.stereo.has_value();
  inspection.rows.resize(session.observations.size());
  for (std::size_t i = 0; i < session.observations.size(); ++i) {
    InspectionRow& row = inspection.rows[i];
    row.id = session.observations[i].id;
    row.index = static_cast<int>(i);
    row.is_used = is_used(session.observations[i]);
    const auto look = looks.find(row.id);
    row.at_second_look = session.observations[i].sightings.empty() && look != looks.end() && !look->second.empty();
  }
  Problem problem = make_problem(with_everything(session, looks), chain_of(session), terms_of(fit));
  if (!problem.terms.empty()) {
    problem.tcp_from_slip = fit.problem.tcp_from_slip;
    place_observations(problem);
  }
  std::vector<Parts> parts;
  std::vector<double> cameras, body;
  for (ProblemObservation& o : problem.observations) {
    InspectionRow& row = inspection.rows[static_cast<std::size_t>(o.index)];
    parts.push_back(measure_row(problem, o, estimate(fit), fit.problem.marker_is_seen, row));
    if (!row.is_used) continue;
    if (parts.back().camera_rows > 0) cameras.push_back(rms(parts.back().cameras, parts.back().camera_rows));
    if (parts.back().body_rows > 0) body.push_back(rms(parts.back().body, parts.back().body_rows));
  }
  const Typical typical{median_of(cameras), median_of(body)};
  for (std::size_t i = 0; i < problem.observations.size(); ++i) {
    const ProblemObservation& o = problem.observations[i];
    judge(problem, o, estimate(fit), fit.noise, parts[i], typical, inspection.rows[static_cast<std::size_t>(o.index)]);
  }
  for (const ObservationReport& o : report.per_observation)
    inspection.rows[static_cast<std::size_t>(o.index)].outlier = o.outlier;
  return inspection;
}

}  // namespace handsight::app
