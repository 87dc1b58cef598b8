// SPDX-License-Identifier: Apache-2.0
#include "estimation/online/online_target.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "estimation/fit/fit_covariance.h"
#include "estimation/fit/noise.h"
#include "estimation/problem/target_pose.h"
#include "estimation/start/shape_start.h"
#include "estimation/start/start.h"
#include "estimation/start/target_symmetry.h"

namespace handsight {
namespace {

constexpr std::size_t fewest_for_mount = 5;  // observations that an unknown mount is first found from

/// The unit of squared residuals that noise alone leaves before anything is known of it.
double usual_noise(const Problem& problem) { return problem.rig ? 0.5 : 1e-3; }

}  // namespace

OnlineTarget::OnlineTarget(const Session& session, const OnlineOptions& options)
    : chain_(make_chain(session)),
      mount_(session.mount),
      options_(options),
      declared_noise_(session.is_tracker() ? session.sigma_point : session.sigma_pixel),
      usual_sigma_(usual_sigma(session) > 0 ? usual_sigma(session)
                                            : declared_noise_.value_or(chain_.rig ? 0.15 : 3e-4)) {
  check(session.shape.has_value(), "a target without a known shape");
  looks_the_same_turned_ = session.target && looks_the_same_turned(*session.target);
  problem_.rig = chain_.rig;
  problem_.shape = session.shape;
  problem_.marker_count = chain_.marker_count;
  problem_.mount_is_estimated = mount_.estimate;
  problem_.marker_is_seen.assign(static_cast<std::size_t>(chain_.marker_count), 0);
}

std::optional<double> OnlineTarget::noise() const {
  if (declared_noise_) return declared_noise_;
  return internal_rows_ < 10 ? std::nullopt : std::optional(std::sqrt(internal_squares_ / internal_rows_));
}

/// Do the points lie as the target has them? What has a wrong number does not.
Message OnlineTarget::target_refusal(const ProblemObservation& posture) {
  bool any = false;
  double squares = 0;
  int rows = 0;
  for (const std::vector<Sighting>& piece : by_piece(*problem_.shape, posture.sightings)) {
    const auto found = target_pose(problem_.rig_or_null(), piece, problem_.shape->markers);
    if (!found) continue;
    any = true;
    squares += found->pose.cost;
    rows += found->pose.rows - 6;
  }
  if (!any)
    return message("{} point{} of the target {} not enough to say where it is", posture.sightings.size(),
                   posture.sightings.size() == 1 ? "" : "s", posture.sightings.size() == 1 ? "is" : "are");
  const double limit = 10 * noise().value_or(usual_noise(problem_));
  const double rms = rows > 0 ? std::sqrt(squares / rows) : 0.0;
  if (rms > limit)
    return message("the points do not lie to each other as on the target: {:.2g} {} rms beside the best pose",
                   problem_.rig ? rms : 1e3 * rms, problem_.rig ? "px" : "mm");
  internal_squares_ += squares;
  internal_rows_ += rows;
  return {};
}

/// The board lies as the estimate has it, not the other way round.
void OnlineTarget::undo_half_turn(ProblemObservation& posture, OnlineStep& step) const {
  if (!looks_the_same_turned_ || !fit_) return;
  const auto seen = target_pose(problem_.rig_or_null(), posture.sightings, problem_.shape->markers);
  if (!seen) return;
  const Unknowns& u = fit_->unknowns();
  const Vector3 expected = sensor_from_tcp_at(posture, u).rotation * (u.markers_in_tcp[1] - u.markers_in_tcp[0]);
  const Vector3 measured =
      seen->pose.sensor_from_body.rotation * (problem_.shape->markers[1] - problem_.shape->markers[0]);
  if (expected.dot(measured) >= 0) return;
  turn_by_half(posture.sightings, problem_.marker_count);
  turn_by_half(step.sightings, problem_.marker_count);
}

void OnlineTarget::start() {
  Problem known = problem_;
  known.observations = waiting_;
  if (mount_.estimate && !mount_.known && waiting_.size() < fewest_for_mount) return;
  if (looks_the_same_turned_) {
    const std::vector<char> turned = half_turned(known, mount_);
    for (std::size_t k = 0; k < turned.size(); ++k)
      if (turned[k]) turn_by_half(waiting_[k].sightings, problem_.marker_count);
    known.observations = waiting_;
  }
  const auto values = start_values(known, mount_);
  if (!values) return;
  // Of measured points the start is not yet rigid.
  Unknowns from = *values;
  if (!problem_.rig) from = laid_onto(*problem_.shape, from);
  fit_.emplace(problem_, from);
  for (const ProblemObservation& o : waiting_) fit_->add(o);
  waiting_.clear();
}

/// A guessed mount may have led astray while there was little to go by.
void OnlineTarget::start_anew() {
  Problem known = problem_;
  known.observations = fit_->observations();
  if (const auto values = start_values(known, mount_))
    fit_->try_from(problem_.rig ? *values : laid_onto(*problem_.shape, *values));
}

BodySides OnlineTarget::sides() const {
  if (options_.sides) return *options_.sides;
  const std::vector<Vector3>& markers =
      problem_.shape->piece_count() == 1 ? problem_.shape->markers : fit_->unknowns().markers_in_tcp;
  std::vector<std::optional<Vector3>> seen;
  for (std::size_t m = 0; m < markers.size(); ++m)
    seen.push_back(problem_.shape->piece_count() == 1 || problem_.marker_is_seen[m] ? std::optional(markers[m])
                                                                                    : std::nullopt);
  return choose_sides(seen);
}

void OnlineTarget::describe(const ProblemObservation& o, OnlineStep& step) const {
  step.has_estimate = true;
  step.kept = fit_->size();
  const Unknowns& u = fit_->unknowns();
  const BodyFrame frame = body_frame(sides(), u.markers_in_tcp);
  step.tcp_from_body = frame.tcp_from_body;
  const auto sigma = noise();
  const int degrees = fit_->rows() - static_cast<int>(fit_->columns());
  const double scale = sigma ? *sigma * *sigma : degrees > 0 ? fit_->cost() / degrees : 0.0;
  if (sigma && *sigma > 0 && degrees > 0 && fit_->size() >= fewest_for_repeatability) {
    const auto test = noise_test(fit_->cost() / (*sigma * *sigma), degrees, declared_noise_ ? 0 : internal_rows_);
    step.covariance_is_scatter = test && test->p < 1e-3;
  }
  const Eigen::MatrixXd covariance =
      step.covariance_is_scatter ? fit_->repeatability_covariance() : Eigen::MatrixXd(scale * fit_->unit_covariance());
  const Eigen::MatrixXd by = frame.motion_by_markers * fit_->markers_by_unknowns();
  step.covariance = by * covariance * by.transpose();
  Matrix6 at_origin = Matrix6::Identity();  // of the origin itself, not of exp(xi)'s translation
  at_origin.topRightCorner<3, 3>() = -cross_matrix(frame.tcp_from_body.translation);
  step.sigma = (at_origin * step.covariance * at_origin.transpose()).diagonal().cwiseMax(0).cwiseSqrt();
  const Rigid sensor_from_tcp = sensor_from_tcp_at(o, u);
  if (const auto pose = estimate_body_pose(problem_.rig_or_null(), o.sightings, u.markers_in_tcp, sensor_from_tcp))
    step.tcp_from_tcp_est = inverse(sensor_from_tcp) * pose->sensor_from_body;
}

OnlineStep OnlineTarget::add(const Observation& observation, const Message& refusal) {
  const auto began = std::chrono::steady_clock::now();
  OnlineStep step;
  step.id = observation.id;
  step.from_images = has_images(observation) && problem_.rig;
  const ObservationState here = states_at(chain_, observation.position);
  const ChainEnds ends = observed_ends(here, moved_sites(here, options_.effects)).ends;
  ProblemObservation posture{
      .root_from_tcp = ends.root_from_tcp, .root_from_mount = ends.root_from_mount, .sightings = observation.sightings};
  for (Sighting& s : posture.sightings) s.usual_sigma = usual_sigma_;
  step.sightings = observation.sightings;
  if (observation.decision == Decision::excluded) step.reason = excluded_text(observation);
  if (step.reason.empty() && last_id_ >= 0)
    step.reason = motion_refusal(chain_, options_, last_position_, observation.position, last_id_);
  if (step.reason.empty()) step.reason = refusal;
  if (step.reason.empty() && posture.sightings.empty())
    step.reason = problem_.rig ? "it has no image, and no point of the target is given" : "its target was not measured";
  if (step.reason.empty()) undo_half_turn(posture, step);
  if (step.reason.empty()) step.reason = target_refusal(posture);
  if (step.reason.empty()) {
    step.accepted = true;
    last_position_ = observation.position;
    last_id_ = observation.id;
    for (const Sighting& s : posture.sightings) problem_.marker_is_seen[static_cast<std::size_t>(s.marker)] = 1;
    if (fit_) {
      fit_->add(posture);
      if (mount_.estimate && mount_.known && fit_->size() == fewest_for_mount) start_anew();
    } else {
      waiting_.push_back(posture);
      start();
    }
  }
  if (fit_) describe(posture, step);
  step.milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - began).count();
  return step;
}

}  // namespace handsight
