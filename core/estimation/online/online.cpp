// SPDX-License-Identifier: Apache-2.0
#include "estimation/online/online.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "chain/sighting.h"
#include "estimation/fit/fit_covariance.h"
#include "estimation/fit/noise.h"
#include "estimation/problem/body_pose.h"
#include "estimation/start/start.h"
#include "estimation/start/start_markers.h"
#include "vision/corners/corner_detector.h"
#include "vision/markers/following_observation.h"

namespace handsight {
namespace {

int markers_needed(int marker_count) { return std::min(3, marker_count); }

/// Are the squares (in units of the noise) more than the noise explains?
bool exceeds_noise(double squares, int degrees, int estimated) {
  const auto test = noise_test(squares, degrees, estimated);
  return test && test->p < 1e-3;
}

double milliseconds_since(std::chrono::steady_clock::time_point began) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - began).count();
}

}  // namespace

OnlineCalibration::OnlineCalibration(const Session& session, OnlineOptions options)
    : chain_(make_chain(session)),
      mount_(session.mount),
      options_(std::move(options)),
      declared_noise_(session.is_tracker() ? session.sigma_point : session.sigma_pixel),
      usual_sigma_(usual_sigma(session) > 0 ? usual_sigma(session)
                                            : declared_noise_.value_or(chain_.rig ? 0.15 : 3e-4)),
      shape_(chain_.marker_count),
      sides_(options_.sides),
      sides_are_kept_(options_.sides.has_value()) {
  problem_.rig = chain_.rig;
  problem_.marker_count = chain_.marker_count;
  problem_.mount_is_estimated = mount_.estimate;
  problem_.marker_is_seen.assign(static_cast<std::size_t>(chain_.marker_count), 0);
  if (session.shape) target_.emplace(session, options_);
}

/// The shape that the poses are measured against is itself estimated from them.
int OnlineCalibration::noise_degrees() const { return internal_rows_ - std::max(0, 3 * problem_.marker_count - 6); }

std::optional<double> OnlineCalibration::noise() const {
  if (target_) return target_->noise();
  if (declared_noise_) return declared_noise_;
  const int degrees = noise_degrees();
  if (degrees < 10) return std::nullopt;
  return std::sqrt(internal_squares_ / degrees);
}

/// The body's shape as the sensor alone knows it, laid onto the estimate's markers. Those markers themselves are no
/// shape to match with: where the arm sags they average poses that differ.
std::vector<Vector3> OnlineCalibration::body_in_tcp() const {
  std::vector<Vector3> in_tcp = fit_->unknowns().markers_in_tcp;
  const auto shape = shape_.markers();
  const auto count = static_cast<Eigen::Index>(shape.size());
  Eigen::Matrix3Xd target = Eigen::Matrix3Xd::Zero(3, count), source = target;
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(count);
  for (Eigen::Index m = 0; m < count; ++m) {
    const auto i = static_cast<std::size_t>(m);
    if (!shape[i] || !problem_.marker_is_seen[i]) continue;
    target.col(m) = in_tcp[i];
    source.col(m) = *shape[i];
    weights[m] = 1;
  }
  if (weights.sum() < 3) return in_tcp;
  const Rigid tcp_from_shape = align_points(target, source, weights);
  for (std::size_t m = 0; m < shape.size(); ++m)
    if (shape[m]) in_tcp[m] = tcp_from_shape * *shape[m];
  return in_tcp;
}

KnownMarkers OnlineCalibration::known_markers() const {
  KnownMarkers known;
  const std::vector<Vector3> in_tcp = body_in_tcp();
  known.sigma = shape_.sigmas();
  for (std::size_t m = 0; m < in_tcp.size(); ++m)
    known.in_body.push_back(problem_.marker_is_seen[m] ? std::optional(in_tcp[m]) : std::nullopt);
  return known;
}

Message OnlineCalibration::find_markers(const std::vector<Corner>& left, const std::vector<Corner>& right,
                                        const ProblemObservation& posture, std::vector<Sighting>& sightings) const {
  // The markers in the TCP frame stand for the body: its prediction is the chain's TCP (thesis 4.52).
  const Rigid prediction = sensor_from_tcp_at(posture, fit_->unknowns());
  const Match match =
      match_markers(make_stereo(*problem_.rig), left, right, known_markers(), prediction, options_.match);
  for (const MatchedMarker& m : match.markers) {
    Sighting s{.marker = m.marker, .by = MarkedBy::tracker};
    const auto take = [&](const Corner& corner, int camera) {
      see(s, camera, corner.position, pixel_sigma(measured_covariance(corner)));
    };
    if (m.left >= 0) take(left[static_cast<std::size_t>(m.left)], 0);
    if (m.right >= 0) take(right[static_cast<std::size_t>(m.right)], 1);
    sightings.push_back(s);
  }
  return match.reason;
}

/// Labels say which marker is which; what can still be wrong is a corner that is not the marker's.
Message OnlineCalibration::label_refusal(const std::vector<Sighting>& sightings) const {
  if (sightings.empty()) return "no marker is labelled and there are no images";
  if (sightings.size() < 4 && static_cast<int>(sightings.size()) < markers_needed(problem_.marker_count)) return {};
  const auto start = body_pose_from_points(problem_.rig_or_null(), sightings, body_in_tcp());
  if (!start) return {};
  const KnownMarkers known = known_markers();
  for (const Sighting& s : sightings) {
    if (!known.in_body[static_cast<std::size_t>(s.marker)]) return {};  // seen for the first time: nothing to compare
  }
  for (const Sighting& s : sightings) {
    Vector3 measured;
    double sigma = known.sigma[static_cast<std::size_t>(s.marker)];
    if (s.point) {
      measured = *s.point;
    } else {
      const auto point = triangulate_unweighed(*problem_.rig, s);
      if (!point) continue;
      measured = point->point;
      sigma = std::hypot(sigma, noise().value_or(0.3) * std::sqrt(point->covariance.trace()));
    }
    const double miss = (measured - *start * *known.in_body[static_cast<std::size_t>(s.marker)]).norm();
    const double limit = options_.match.marker_gate + 3 * sigma;
    if (miss > limit)
      return message("marker {} is {:.1f} mm from where it must be on the body (limit {:.1f})", s.marker, 1e3 * miss,
                     1e3 * limit);
  }
  return {};
}

/// Empty when the calibration has started; else why it has not yet.
Message OnlineCalibration::start(const ProblemObservation& first) {
  const auto needed = static_cast<std::size_t>(markers_needed(problem_.marker_count));
  std::size_t points = 0;
  for (const Sighting& s : first.sightings) points += s.point || s.in_cameras.size() > 1 ? 1 : 0;
  if (points < needed)
    return message("the first observation needs {} labelled markers seen as points, and has {}", needed, points);
  waiting_.push_back(first);
  Problem known = problem_;
  known.observations = waiting_;
  if (mount_.estimate && !mount_.known && waiting_.size() < most_waiting) return {};
  const auto values = start_values(known, mount_.known ? Mount{mount_.link, mount_.mount_from_sensor} : mount_);
  if (!values) return "no start for the mount can be found from it";
  start_from(waiting_, *values);
  waiting_.clear();
  return {};
}

void OnlineCalibration::start_from(const std::vector<ProblemObservation>& observations, const Unknowns& values) {
  fit_.emplace(problem_, values);
  for (std::size_t i = 0; i + 1 < observations.size(); ++i)  // the last one follows with every accepted observation
    shape_.add(problem_.rig_or_null(), observations[i].sightings, noise().value_or(problem_.rig ? 0.3 : 3e-4));
  for (const ProblemObservation& o : observations) {
    for (const Sighting& s : o.sightings) problem_.marker_is_seen[static_cast<std::size_t>(s.marker)] = 1;
    fit_->add(o);
  }
}

/// A marker that the first observation did not show gets its start where it is first seen.
void OnlineCalibration::learn_new_markers(const ProblemObservation& observation) {
  Problem one = problem_;
  one.observations = {observation};
  const std::vector<Vector3> markers = start_markers(one, fit_->unknowns().mount_from_sensor);
  for (const Sighting& s : observation.sightings) {
    char& seen = problem_.marker_is_seen[static_cast<std::size_t>(s.marker)];
    if (!seen) fit_->place_marker(s.marker, markers[static_cast<std::size_t>(s.marker)]);
    seen = 1;
  }
}

void OnlineCalibration::learn_shape_and_noise(const ProblemObservation& o) {
  const Rigid guess = sensor_from_tcp_at(o, fit_->unknowns());
  const auto pose = estimate_body_pose(problem_.rig_or_null(), o.sightings, body_in_tcp(), guess);
  shape_.add(problem_.rig_or_null(), o.sightings, noise().value_or(problem_.rig ? 0.3 : 3e-4));
  if (!pose || pose->rows <= 6) return;
  internal_squares_ += pose->cost;
  internal_rows_ += pose->rows - 6;
}

/// The sides of the frame are kept once they are clear: the longest is longer than the next, and that one than the
/// third, by 3 sigma, or enough observations have been taken. One distant observation alone often cannot tell.
void OnlineCalibration::decide_sides() {
  if (sides_are_kept_) return;
  constexpr std::size_t enough = 20;
  std::vector<std::optional<Vector3>> markers;
  const std::vector<Vector3> in_tcp = body_in_tcp();
  for (std::size_t m = 0; m < problem_.marker_is_seen.size(); ++m)
    markers.push_back(problem_.marker_is_seen[m] ? std::optional(in_tcp[m]) : std::nullopt);
  sides_ = choose_sides(markers);
  if (fit_->size() >= enough || !sides_->second) {
    sides_are_kept_ = fit_->size() >= enough;
    return;
  }
  const std::vector<double> sigma = shape_.sigmas();
  auto length = [&](int a, int b) {
    return (in_tcp[static_cast<std::size_t>(b)] - in_tcp[static_cast<std::size_t>(a)]).norm();
  };
  auto same = [](const BodySide& s, int a, int b) { return s.from == a && s.to == b; };
  const double longest = length(sides_->longest->from, sides_->longest->to),
               second = length(sides_->second->from, sides_->second->to);
  bool clear = true;
  for (const int a : sides_->markers)
    for (const int b : sides_->markers) {
      if (b <= a || same(*sides_->longest, a, b)) continue;
      const double margin = 3 * 2 * std::hypot(sigma[static_cast<std::size_t>(a)], sigma[static_cast<std::size_t>(b)]);
      clear =
          clear && longest - length(a, b) > margin && (same(*sides_->second, a, b) || second - length(a, b) > margin);
    }
  sides_are_kept_ = clear;
}

void OnlineCalibration::describe(const ProblemObservation& o, OnlineStep& step) const {
  step.has_estimate = true;
  step.kept = fit_->size();
  const BodyFrame frame = body_frame(*sides_, fit_->unknowns().markers_in_tcp);
  step.tcp_from_body = frame.tcp_from_body;
  const Eigen::Index markers = 3 * problem_.marker_count;
  const auto sigma = noise();
  const int degrees = fit_->rows() - static_cast<int>(problem_.columns()) + fit_->unobservable();
  const double scale = sigma ? *sigma * *sigma : degrees > 0 ? fit_->cost() / degrees : 0.0;
  if (sigma && *sigma > 0 && degrees > 0 && fit_->size() >= fewest_for_repeatability)
    step.covariance_is_scatter =
        exceeds_noise(fit_->cost() / (*sigma * *sigma), degrees, declared_noise_ ? 0 : noise_degrees());
  const Eigen::MatrixXd covariance =
      step.covariance_is_scatter ? fit_->repeatability_covariance() : Eigen::MatrixXd(scale * fit_->unit_covariance());
  step.covariance = body_covariance(frame, covariance.topLeftCorner(markers, markers));
  // Of the origin itself, not of exp(xi)'s translation, which turns with the rotation about the TCP.
  Matrix6 at_origin = Matrix6::Identity();
  at_origin.topRightCorner<3, 3>() = -cross_matrix(frame.tcp_from_body.translation);
  step.sigma = (at_origin * step.covariance * at_origin.transpose()).diagonal().cwiseMax(0).cwiseSqrt();
  const Rigid sensor_from_tcp = sensor_from_tcp_at(o, fit_->unknowns());
  if (const auto pose =
          estimate_body_pose(problem_.rig_or_null(), step.sightings, fit_->unknowns().markers_in_tcp, sensor_from_tcp))
    step.tcp_from_tcp_est = inverse(sensor_from_tcp) * pose->sensor_from_body;
}

OnlineStep OnlineCalibration::add(const Observation& observation, const ImagePair* images, const Message& not_found) {
  if (target_) return target_->add(observation, not_found);
  const auto began = std::chrono::steady_clock::now();
  OnlineStep step;
  step.id = observation.id;
  const ObservationState here = states_at(chain_, observation.position);
  const ChainEnds ends = observed_ends(here, moved_sites(here, options_.effects)).ends;
  ProblemObservation posture{.root_from_tcp = ends.root_from_tcp, .root_from_mount = ends.root_from_mount};
  const bool first = !fit_;
  if (observation.decision == Decision::excluded) {
    step.reason = excluded_text(observation);
  } else {
    if (last_id_ >= 0) step.reason = motion_refusal(chain_, options_, last_position_, observation.position, last_id_);
  }
  if (step.reason.empty() && searches_mount(observation, images)) {
    leave_open(observation, images, posture, step);
    step.milliseconds = milliseconds_since(began);
    return step;
  }
  if (step.reason.empty()) {
    if (!first && images) {
      step.from_images = true;
      step.reason = find_markers(detect_corners(images->left, options_.detector),
                                 detect_corners(images->right, options_.detector), posture, step.sightings);
    } else {
      step.sightings = observation.sightings;
      if (!first) step.reason = label_refusal(step.sightings);
      if (first && step.sightings.empty()) step.reason = "no observation before it is labelled; label one first";
    }
  }
  posture.sightings = step.sightings;
  for (Sighting& s : posture.sightings) s.usual_sigma = usual_sigma_;
  if (step.reason.empty() && first) step.reason = start(posture);
  if (step.reason.empty()) {
    step.accepted = true;
    last_position_ = observation.position;
    last_id_ = observation.id;
    if (!first) {
      learn_new_markers(posture);
      fit_->add(posture);
    }
    if (fit_) learn_shape_and_noise(posture);
    if (fit_) decide_sides();
  }
  if (fit_) describe(posture, step);
  step.milliseconds = milliseconds_since(began);
  return step;
}

}  // namespace handsight
