// SPDX-License-Identifier: Apache-2.0
#include "estimation/fit/fit.h"

#include <algorithm>
#include <cmath>

#include "chain/body_factor.h"
#include "effects/term_numbers.h"
#include "estimation/fit/fit_covariance.h"
#include "estimation/fit/fit_noise.h"
#include "estimation/fit/fit_parts.h"
#include "estimation/fit/flange_error_size.h"
#include "estimation/fit/objectives.h"
#include "estimation/fit/slip_frames.h"
#include "estimation/fit/sure_fit.h"
#include "estimation/fit/touch_counts.h"
#include "estimation/fit/touch_unknown.h"
#include "estimation/fit/undetermined.h"
#include "estimation/problem/pose_residuals.h"
#include "estimation/problem/robot_scale.h"
#include "estimation/solvers/covariance_factor.h"
#include "estimation/start/multi_start.h"
#include "estimation/start/start.h"
#include "estimation/start/touch_start.h"
#include "session/pose_points.h"

namespace handsight {
namespace {

std::string session_name(const Session& session) { return session.file.filename().string(); }

/// TCP->Body and effects explain the same measurements, so that their errors go together. `factor`: of the covariance
/// of the problem's columns.
void set_model_covariance(const BodyFrame& frame, const Eigen::MatrixXd& factor, Fit& fit) {
  const Eigen::MatrixXd of_body = body_factor(frame, factor.topRows(3 * fit.problem.marker_count));
  const std::vector<Eigen::Index> first_of_term = first_numbers(fit.problem.terms, 6);
  Eigen::MatrixXd of_model = Eigen::MatrixXd::Zero(first_of_term.back(), of_body.cols());
  of_model.topRows<6>() = of_body;
  for (std::size_t c = 0; c < fit.problem.columns_of_effects.size(); ++c) {
    const EffectColumn& column = fit.problem.columns_of_effects[c];
    of_model.row(first_of_term[column.term] + static_cast<Eigen::Index>(column.parameter)).head(factor.cols()) =
        factor.row(fit.problem.effect_column() + static_cast<Eigen::Index>(c));
  }
  fit.model_covariance = covariance_from(of_model);
  fit.covariance = fit.model_covariance.topLeftCorner<6, 6>();
}

void set_body(const FitOptions& options, const Eigen::MatrixXd& factor, Fit& fit) {
  fit.sides = make_sides(options, fit.problem, fit.solution.unknowns);
  if (fit.sides.markers.empty()) return;
  const Matrix3 start = options.start_tcp_from_body ? options.start_tcp_from_body->rotation : Matrix3::Identity();
  const BodyFrame frame = body_frame(fit.sides, fit.solution.unknowns.markers_in_tcp, start);
  fit.tcp_from_body = frame.tcp_from_body;
  fit.rotation_is_observed = frame.unobserved.cols() == 0;
  set_model_covariance(frame, factor, fit);
  const Rigid body_from_tcp = inverse(frame.tcp_from_body);
  for (const Vector3& x : fit.solution.unknowns.markers_in_tcp) fit.markers_in_body.push_back(body_from_tcp * x);
  if (fit.rotation_is_observed) return;
  if (fit.sides.markers.size() == 1)
    fit.notes.push_back(
        message("{} cannot show how the body is turned on the hand: its rotation stays as it was at the start.",
                fit.problem.source->chain.is_touch ? "A tip" : "One marker"));
  else
    fit.notes.push_back(
        "Two markers show only partly how the body is turned on the hand: its turn about the line through both stays "
        "as it was at the start.");
}

/// Directions of the fixtures' frames that mean nothing: a plane turned and shifted in itself.
int no_matter(const Session& session) {
  int count = 0;
  for (std::size_t f = 0; f < session.fixtures.size(); ++f)
    if (find_mount(session, part_of_fixture(session, static_cast<int>(f)).mount).estimate)
      count += 6 - static_cast<int>(list_numbers(*session.fixtures[f].kind).size());
  return count;
}

void add_notes(const Session& session, Fit& fit) {
  if (fit.problem.observations.size() == 1)
    fit.notes.push_back("Only one observation is used: tcp_from_body is that of thesis (4.35), and nothing checks it.");
  if (holds_robot_scale(fit.problem) && session.is_touch())
    fit.notes.push_back(
        "Nothing that was touched tells a length: the robot's size is taken from its description, within 0.1 %. Two "
        "sockets of known distance (<apart>), a ball bar or a fixture whose place is known would tell it.");
  else if (holds_robot_scale(fit.problem))
    fit.notes.push_back(
        "Nothing that was measured tells a length (every marker was measured at one place only): the robot's size is "
        "taken from its description, within 0.1 %. Measure a marker at two places of known distance to find it.");
  if (fit.problem.flange_error.is_any())
    fit.notes.push_back(flange_error_text(fit.problem.flange_error, !session.robot.is_of_poses));
  if (const Message turns = turn_misfit_text(fit.problem, fit.solution.unknowns); !turns.empty())
    fit.notes.push_back(turns);
  std::vector<std::size_t> unseen;
  for (std::size_t m = 0; m < fit.problem.marker_is_seen.size(); ++m)
    if (!fit.problem.marker_is_seen[m]) unseen.push_back(m);
  if (unseen.size() == 1)
    fit.notes.push_back(message("Marker {} is seen in no used observation and has no position.", unseen.front()));
  if (unseen.size() > 1)
    fit.notes.push_back(
        message("Markers {} are seen in no used observation and have no position.", fmt::join(unseen, ", ")));
  if (fit.sightings_left_out > 0)
    fit.notes.push_back(
        message("{} sightings by one camera only cannot take part in this objective, which needs triangulated points.",
                fit.sightings_left_out));
  const std::vector<Message> undetermined = unknown_texts(session, fit);
  fit.notes.insert(fit.notes.end(), undetermined.begin(), undetermined.end());
  if (fit.solution.unobservable > no_matter(session) && undetermined.empty())
    fit.notes.push_back(
        message("{} direction{} of the unknowns cannot be observed in these poses and stay as they were.",
                fit.solution.unobservable - no_matter(session),
                fit.solution.unobservable - no_matter(session) == 1 ? "" : "s"));
  if (!fit.solution.normal.in_front)
    fit.notes.push_back(
        "A marker would lie behind a camera that saw it: this is no answer; check the mount, the cameras and the "
        "labels.");
  else if (fit.objective == Objective::image && is_no_answer(fit.problem, fit.solution))
    fit.notes.push_back(
        "What is left is more than any robot explains: this is no answer; check mount, cameras, joints' order and "
        "labels.");
  else if (fit.objective == Objective::image && fit.solution.converged && looks_lost(fit.problem, fit.solution))
    fit.notes.push_back(
        "So large an error is rare: before any number is used, make sure that mount, rig, joints and labels are "
        "right.");
  else if (!fit.solution.converged)
    fit.notes.push_back(message("The fit did not converge in {} iterations.", fit.solution.iterations));
  for (std::size_t t = 0; t < fit.problem.terms.size(); ++t)
    if (const double times = widened_by(fit.problem, t); times > 1.5)
      fit.notes.push_back(
          message("{}: the measurements say more than 5 times what is plausible; its prior sigmas were taken {:.0f} "
                  "times as large.",
                  fit.problem.terms[t].id, times));
  for (const ProblemObservation& o : fit.problem.observations) {
    const Observation& observation = session.observations[static_cast<std::size_t>(o.index)];
    if (!o.springs_hold)
      fit.notes.push_back(message("Observation {}: the declared springs are too soft for the load.", observation.id));
  }
}

}  // namespace

namespace {

void refuse_cameras_of_points(const Session& session, const FitOptions& options, const Problem& images) {
  if (options.objective == Objective::image || options.estimated.empty()) return;
  const bool cameras = images.cameras_by_effect.cols() > 0;
  if (options.objective == Objective::camera && !cameras) return;
  throw InputError(message("{}: the {} objective cannot estimate {}; use the image objective.", session_name(session),
                           options.objective == Objective::camera ? "camera" : "angle-axis",
                           cameras ? "effects of the cameras" : "effects"));
}

void require_use_of_camera_images(const Session& session, const FitOptions& options, const Problem& images) {
  if (!options.camera_images) return;
  if (!images.rig || images.cameras_by_effect.cols() == 0)
    throw InputError(
        message("{}: images of a board say something of the cameras, and no number of theirs is estimated; add "
                "--effects camera_intrinsics (also lens_distortion{}).",
                session_name(session),
                verbatim(!session.rig || session.rig->count() == 1 ? ""
                         : session.rig->count() == 2               ? ", stereo_rig"
                                                                   : ", rig")));
}

void set_effect_results(const std::size_t held, Fit& fit) {
  const Eigen::Index first = fit.problem.effect_column();
  for (std::size_t t = 0; t < fit.problem.terms.size(); ++t) {
    FittedEffect fitted{fit.problem.terms[t], std::vector<double>(fit.problem.terms[t].values.size(), 0.0)};
    for (std::size_t c = 0; t >= held && c < fit.problem.columns_of_effects.size(); ++c) {
      const EffectColumn& column = fit.problem.columns_of_effects[c];
      const Eigen::Index i = first + static_cast<Eigen::Index>(c);
      if (column.term == t && i < fit.parameter_covariance.cols())
        fitted.sigmas[column.parameter] = std::sqrt(std::max(fit.parameter_covariance(i, i), 0.0));
    }
    fit.effects.push_back(fitted);
  }
}

Fit fit_as_given(const Session& session, const FitOptions& options);

/// Nothing where nothing can be found.
std::optional<Unknowns> start_for(const Session& session, const FitOptions& options, const Problem& images) {
  if (options.start) return options.start;
  if (session.parts.empty()) return start_values(images, session.mount);
  FitOptions alone;
  alone.on_iteration = options.on_iteration;
  if (session.is_touch()) {
    if (const auto untouched = untouched_text(session)) throw InputError(*untouched);
    if (options.estimated.empty()) return touch_start(session, images);
    // From rough places a joint's zero and all fixtures turn far together, and come back slowly.
    alone.effects = options.effects;
    const Fit places = fit_as_given(session, alone);
    require_determined(session, places);
    return estimate(places);
  }
  return start_of_parts(session, images, [&](const Session& part) { return fit_as_given(part, alone); });
}

void refuse_objectives_of_parts(const Session& session, const FitOptions& options) {
  if (session.parts.empty() || options.objective != Objective::angle_axis) return;
  throw InputError(message("{}: the angle-axis objective is of one session; fit a collection by the image objective.",
                           session.title));
}

Fit fit_as_given(const Session& session, const FitOptions& options) {
  refuse_objectives_of_parts(session, options);
  const Chain chain = make_chain(session);
  Problem images = make_problem(session, chain, options.effects, options.estimated);
  if (images.observations.empty())
    throw InputError(
        session.target
            ? message("{}: the target is found in none of the {} observations that may be used; look at an image "
                      "and at what <target> says of it.",
                      session_name(session), session.observations.size())
            : message("{}: none of the {} observations has a labelled marker that may be used; label one first "
                      "(handsight-cli label).",
                      session_name(session), session.observations.size()));
  auto start = start_for(session, options, images);
  if (start) start->effects = effect_values(images);
  if (!start)
    throw InputError(message(
        "{}: nothing is known of the mount, and no marker is seen by two cameras, so that no start can be found; give "
        "{} an xyz and rpy.",
        session_name(session),
        !session.rig || is_left_and_right(*session.rig) ? "mount_from_left" : "mount_from_first"));
  refuse_cameras_of_points(session, options, images);
  require_use_of_camera_images(session, options, images);
  images.camera_images = options.camera_images;

  Fit result;
  result.objective = options.objective;
  result.fixed_markers =
      options.fix_markers || options.objective == Objective::angle_axis || (images.shape && images.shape->is_rigid());
  if (images.effect_count() > 0 || images.shape || session.robot.is_of_poses) set_prior_noise(session, *start, images);
  if (has_slip(images)) {
    start_slip_frames(options, *start, images);  // settled below
    place_observations(images);
  }
  // Of a long session every copy counts: where the images themselves are fitted there is one problem.
  const bool are_images = options.objective == Objective::image;
  result.problem = are_images ? std::move(images) : as_points(images, result.sightings_left_out);
  Problem& measured = are_images ? result.problem : images;  // NOLINT(bugprone-use-after-move): moved where not used
  if (result.problem.observations.empty())
    throw InputError(message(
        "{}: no marker is seen by two cameras in any used observation, which the {} objective needs; use the image "
        "objective.",
        session_name(session), options.objective == Objective::camera ? "camera" : "angle-axis"));
  if (options.objective == Objective::camera) result.problem.noise = 1e-3;  // points: m
  const double pose_noise =
      options.objective == Objective::angle_axis ? noise_at_start(session, measured, *start).value_or(1) : 1;
  result.loss_noise = loss_noise(session, measured, result.problem, *start, options);
  minimise_surely(session, measured, *start, options, pose_noise, result);
  settle_slip_frames(session, options, measured, result);
  if (measured.effect_count() > 0) {
    set_effects(result.problem, result.solution.unknowns.effects);
    if (!are_images) set_effects(images, result.solution.unknowns.effects);
  }
  set_noise(session, measured, result);
  Eigen::MatrixXd factor =
      covariance_factor(measured, options, declared_noise(session).has_value() || !result.noise_estimate, result);
  add_shape_columns(result, factor);
  if (session.is_touch())
    add_undetermined_columns_of_touches(session, result, factor);
  else
    add_undetermined_columns(result, factor);
  result.parameter_covariance = covariance_from(factor);
  set_body(options, factor, result);
  // What moves the body may be asked for later, of a model that has nothing of the kind yet.
  if (!has_slip(result.problem)) {
    result.problem.tcp_from_slip = result.tcp_from_body;
    set_slip_frames(result.problem, estimate(result).markers_in_tcp);
  }
  set_effect_results(options.effects.size(), result);
  add_notes(session, result);
  return result;
}

}  // namespace

Fit fit(const Session& session, const FitOptions& options) {
  if (session.is_touch() && options.estimated.empty() && !options.start) {
    Fit result = fit_as_given(session, options);
    require_determined(session, result);
    return result;
  }
  if (!has_unknown_lever(session)) return fit_as_given(session, options);
  FitOptions quiet = options;
  quiet.on_iteration = nullptr;
  Session seen = session;
  for (int pass = 0; pass < 2; ++pass) {
    const Fit rough = fit_as_given(seen, quiet);
    show_poses(seen, seen_lever(rough.problem, estimate(rough)));
  }
  return fit_as_given(seen, options);
}

}  // namespace handsight
