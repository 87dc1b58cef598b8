// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/attribution/inspection.h"

#include <algorithm>

#include "chain/sighting.h"
#include "estimation/problem/pose_residuals.h"
#include "estimation/report/hand_residual.h"
#include "session/by_time.h"
#include "session/fixtures/fixture_kind.h"
#include "session/sample.h"

namespace handsight {
namespace {

std::optional<Vector2> pixel_in(const Sighting& s, int camera) {
  const CameraPoint* const seen = seen_by(s, camera);
  return seen ? std::optional(seen->pixel) : std::nullopt;
}

std::vector<ImageCorner> corners_of(const Rig* rig, const Sighting& s, const Vector3& predicted_in_sensor) {
  std::vector<ImageCorner> corners;
  corners.reserve(rig ? static_cast<std::size_t>(rig->count()) : 0);
  for (int camera = 0; rig && camera < rig->count(); ++camera) {
    corners.push_back({.measured = pixel_in(s, camera)});
    const Vector3 in_camera = rig->at(camera).camera_from_first * predicted_in_sensor;
    if (in_camera.z() > 1e-6) corners.back().predicted = project(rig->at(camera).camera, in_camera);
  }
  return corners;
}

void note_worst(const MarkerResidual& marker, InspectionRow& row) {
  const auto look = [&](double size, int camera) {
    if (size <= row.worst_size) return;
    row.worst_size = size;
    row.worst_marker = marker.marker;
    row.worst_camera = camera;
  };
  for (std::size_t i = 0; i < marker.corners.size(); ++i)
    if (const ImageCorner& c = marker.corners[i]; c.is_compared())
      look((*c.measured - *c.predicted).norm(), static_cast<int>(i));
  if (!marker.is_seen() && marker.measured_in_sensor)
    look((*marker.measured_in_sensor - marker.predicted_in_sensor).norm(), -1);
}

/// The direction in which a sighting reads one coordinate of the marker alone, a touch; nothing where it tells a whole
/// place. Sensors of poses read points of a known shape so, which stand for a pose.
std::optional<Vector3> read_along(const Problem& problem, const ProblemObservation& o, const Sighting& s,
                                  const Vector3& predicted_in_sensor) {
  if (s.reading) return s.reading->by_tip(predicted_in_sensor);
  const bool is_pose = problem.shape && o.sightings.size() == pose_markers;
  return is_pose ? std::nullopt : s.along;
}

/// Where a reading has the marker: it says nothing across its direction, where the marker is as predicted.
Vector3 read_place(const Sighting& s, const Vector3& along, const Vector3& predicted_in_sensor) {
  const double off = s.reading ? s.reading->of(*s.point) - s.reading->of(predicted_in_sensor)
                               : along.dot(*s.point - predicted_in_sensor);
  return predicted_in_sensor + off * along;
}

/// Fills what the row shows of the observation's markers and pose.
ResidualParts measure(const Problem& problem, const ProblemObservation& o, const Unknowns& unknowns,
                      InspectionRow& row) {
  const Rig* rig = problem.rig_or_null();
  const Rigid sensor_from_tcp = sensor_from_tcp_at(o, unknowns);
  double lengths = 0;
  double variances = 0, squared_variances = 0;  // of the points in space, for a noise of 1 px (1 m) a coordinate
  const auto add_variance = [&](const Matrix3& covariance) {
    variances += covariance.trace();
    squared_variances += covariance.squaredNorm();
  };
  row.markers.reserve(o.sightings.size());
  for (const Sighting& s : o.sightings) {
    MarkerResidual marker{.marker = s.marker};
    marker.predicted_in_sensor = sensor_from_tcp * marker_at(o, unknowns, s.marker);
    marker.corners = corners_of(rig, s, marker.predicted_in_sensor);
    marker.measured_in_sensor = s.point;
    if (const auto along = s.point ? read_along(problem, o, s, marker.predicted_in_sensor) : std::nullopt) {
      marker.measured_in_sensor = read_place(s, *along, marker.predicted_in_sensor);
      add_variance(*along * along->transpose());
    } else if (s.point) {
      add_variance(Matrix3::Identity());
    }
    if (rig)
      if (const auto point = triangulate_unweighed(*rig, s)) {
        marker.measured_in_sensor = point->point;
        add_variance(point->covariance);
      }
    if (marker.measured_in_sensor) {
      lengths += (*marker.measured_in_sensor - marker.predicted_in_sensor).squaredNorm();
      ++row.points;
    }
    note_worst(marker, row);
    row.markers.push_back(std::move(marker));
  }
  ResidualParts parts = residual_parts(problem, o, unknowns);
  row.coordinates = parts.rows;
  if (parts.rows > 0) row.rms = std::sqrt(parts.total / parts.rows);
  if (row.points > 0) {
    row.rms_m = std::sqrt(lengths / row.points);
    row.noise_m = std::sqrt(variances / row.points);
    // Satterthwaite: a sum of unlike squares is nearly one of so many like ones.
    row.noise_coordinates = variances * variances / squared_variances;
  }
  if (const auto hand = rig ? hand_residual(problem, o, unknowns) : std::nullopt) {
    const Matrix3& c = hand->unit_covariance;
    row.hand_m = hand->size_m;
    row.noise_of_hand_m = std::sqrt(c.trace());
    row.hand_coordinates = c.trace() * c.trace() / c.squaredNorm();
  }
  if (!parts.sensor_from_body) return parts;
  row.tcp_from_tcp_est = inverse(sensor_from_tcp) * *parts.sensor_from_body;
  row.angle = vector_from_rotation(row.tcp_from_tcp_est->rotation).norm();
  return parts;
}

/// As if every observation that shows markers counted.
void count_everything(const SecondLooks& looks, Session& session) {
  for (Observation& o : session.observations) {
    o.decision = Decision::none;
    if (const auto look = looks.find(o.id); look != looks.end() && o.sightings.empty()) o.sightings = look->second;
  }
}

void forget_unknown(const std::vector<char>& marker_is_known, ProblemObservation& seen) {
  std::erase_if(seen.sightings,
                [&](const Sighting& s) { return !marker_is_known[static_cast<std::size_t>(s.marker)]; });
}

/// The observations of a session, every one that shows markers counted, as a fit's model places them: a stretch at a
/// time, because of a long session every copy counts.
class ShownStretches {
 public:
  ShownStretches(const Session& session, const Fit& fit, const SecondLooks& looks)
      : session_(session), fit_(fit), looks_(looks), order_(by_time(session)), usual_sigma_(usual_sigma(session)) {}

  /// `see` is called with the problem of the stretch and each of its observations, whose index is into the session.
  template <class See>
  void each(const See& see) {
    for (std::size_t first = 0; first < order_.size(); first += at_once) {
      if (first != first_) make(first);
      for (const ProblemObservation& o : problem_.observations)
        see(problem_, o, order_[first + static_cast<std::size_t>(o.index)]);
    }
  }

 private:
  static constexpr std::size_t at_once = 4000, none = static_cast<std::size_t>(-1);

  void make(std::size_t first) {
    const auto begin = order_.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = order_.begin() + static_cast<std::ptrdiff_t>(std::min(first + at_once, order_.size()));
    problem_ = {};
    Session shown = take_part(session_, {begin, end});
    count_everything(looks_, shown);
    if (session_.pose_sensor) shown = shown_as_fitted(shown, estimate(fit_));
    problem_ = make_problem(shown, make_chain(shown), list_terms(fit_));
    if (!problem_.terms.empty()) {
      problem_.copy_slip_frames(fit_.problem);
      place_observations(problem_);
    }
    for (ProblemObservation& o : problem_.observations) {
      forget_unknown(fit_.problem.marker_is_seen, o);
      if (order_.size() > at_once)
        for (Sighting& s : o.sightings) s.usual_sigma = usual_sigma_;
    }
    first_ = first;
  }

  const Session& session_;
  const Fit& fit_;
  const SecondLooks& looks_;
  const std::vector<int> order_;
  const double usual_sigma_;  // of the whole session
  std::size_t first_ = none;
  Problem problem_;
};

ResidualParts measure_row(const Problem& problem, const ProblemObservation& seen, const Unknowns& unknowns,
                          InspectionRow& row) {
  row.root_from_tcp = seen.root_from_tcp;
  row.root_from_sensor = seen.root_from_mount * find_mount(seen, unknowns) * seen.sensor_motion;
  return measure(problem, seen, unknowns, row);
}

void judge(const Problem& problem, const ProblemObservation& seen, const Unknowns& unknowns,
           std::optional<double> noise, const ResidualParts& parts, const TypicalParts& typical, InspectionRow& row) {
  if (!noise || !row.rms || *noise <= 0) {
    row.noise_m.reset();
    row.noise_of_hand_m.reset();
    return;
  }
  if (row.noise_m) *row.noise_m *= *noise;
  if (row.noise_of_hand_m) *row.noise_of_hand_m *= *noise;
  row.ratio = *row.rms / *noise;
  row.attribution = attribute_error(parts, *noise, typical);
  SingleChange change = single_change(problem, seen, unknowns, *noise, typical, parts, row.attribution.cause);
  // How far off the hand is is one figure, whoever tells it.
  if (change.kind == SingleChange::Kind::pose) change.size = row.hand_m.value_or(row.rms_m.value_or(change.size));
  row.what_would_mend = change_text(change, problem.rig_or_null());
  row.smallest_visible = smallest_visible(problem, seen, unknowns, *noise);
}

}  // namespace

void inspect_observation(const Problem& problem, const ProblemObservation& observation, const Unknowns& unknowns,
                         std::optional<double> noise, const std::vector<char>& marker_is_known, InspectionRow& row) {
  ProblemObservation seen = observation;
  forget_unknown(marker_is_known, seen);
  const ResidualParts parts = measure_row(problem, seen, unknowns, row);
  judge(problem, seen, unknowns, noise, parts, {}, row);
}

Inspection inspect(const Session& session, const Fit& fit, const FitReport& report, const SecondLooks& looks) {
  Inspection inspection;
  inspection.noise = fit.noise;
  inspection.in_pixels = session.rig.has_value();
  inspection.rows.resize(session.observations.size());
  for (std::size_t i = 0; i < session.observations.size(); ++i) {
    InspectionRow& row = inspection.rows[i];
    row.id = session.observations[i].id;
    row.index = static_cast<int>(i);
    row.is_used = is_used(session.observations[i]);
    const auto look = looks.find(row.id);
    row.at_second_look = session.observations[i].sightings.empty() && look != looks.end() && !look->second.empty();
  }
  ShownStretches shown(session, fit, looks);
  std::vector<ResidualParts> parts, used;
  shown.each([&](const Problem& problem, const ProblemObservation& o, int index) {
    InspectionRow& row = inspection.rows[static_cast<std::size_t>(index)];
    parts.push_back(measure_row(problem, o, estimate(fit), row));
    if (row.is_used) used.push_back(parts.back());
  });
  const TypicalParts typical = typical_parts(used);
  if (fit.noise && *fit.noise > 0) inspection.attribution = attribute_error(used, *fit.noise);
  auto next = parts.begin();
  shown.each([&](const Problem& problem, const ProblemObservation& o, int index) {
    judge(problem, o, estimate(fit), fit.noise, *next++, typical, inspection.rows[static_cast<std::size_t>(index)]);
  });
  inspection.noise_m = report.rms_of_noise_m;
  for (const ObservationReport& o : report.per_observation)
    inspection.rows[static_cast<std::size_t>(o.index)].outlier = o.outlier;
  return inspection;
}

void mark_left_out(const std::vector<WrongPoint>& points, const std::vector<LoneObservation>& lone,
                   Inspection& inspection) {
  for (const WrongPoint& w : points) inspection.rows[static_cast<std::size_t>(w.index)].outlier = true;
  for (const LoneObservation& l : lone) inspection.rows[static_cast<std::size_t>(l.index)].outlier = true;
}

}  // namespace handsight
