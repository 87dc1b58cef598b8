// SPDX-License-Identifier: Apache-2.0
#include "estimation/fit.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>

#include "effects/term_numbers.h"
#include "estimation/competition.h"
#include "estimation/objectives.h"
#include "estimation/start.h"

namespace handsight {
namespace {

/// Few observations cannot show how observations scatter: below this the scale of the residuals is used instead.
constexpr std::size_t fewest_for_scatter = 10;

std::string session_name(const Session& session) { return session.file.filename().string(); }

BodySides sides_of(const FitOptions& options, const Problem& problem, const Unknowns& unknowns) {
  if (options.sides) return *options.sides;
  std::vector<std::optional<Vector3>> markers;
  for (std::size_t m = 0; m < unknowns.markers_in_tcp.size(); ++m)
    markers.push_back(problem.marker_is_seen[m] ? std::optional(unknowns.markers_in_tcp[m]) : std::nullopt);
  return choose_sides(markers);
}

/// Sum over observations of the outer product of their gradients: how much observations differ, whatever the cause.
Eigen::MatrixXd clustered_middle(const Problem& problem, const Unknowns& unknowns) {
  Eigen::MatrixXd middle = Eigen::MatrixXd::Zero(problem.columns(), problem.columns());
  for (const ProblemObservation& o : problem.observations) {
    NormalEquations one(problem.columns());
    add_observation(problem, o, unknowns, one);
    middle.selfadjointView<Eigen::Lower>().rankUpdate(one.gradient);
  }
  for (Eigen::Index i = 0; i < problem.effect_count(); ++i) {  // a prior is one more measurement, with its own scatter
    const Eigen::Index column = problem.effect_column() + i;
    const double sigma = problem.columns_of_effects[static_cast<std::size_t>(i)].sigma;
    middle(column, column) += std::pow(problem.noise / sigma, 2) * problem.noise * problem.noise;
  }
  return middle.selfadjointView<Eigen::Lower>();
}

void set_noise(const Session& session, const Problem& images, Fit& fit) {
  fit.noise_estimate = estimate_noise(images, fit.solution.unknowns);
  const auto declared = session.is_tracker() ? session.sigma_point : session.sigma_pixel;
  if (!declared && !fit.noise_estimate) fit.noise_estimate = noise_from_repeats(images, fit.solution.unknowns);
  if (declared) {
    fit.noise = declared;
  } else if (fit.noise_estimate) {
    fit.noise = fit.noise_estimate->sigma;
    if (fit.noise_estimate->from_repeats)
      fit.notes.push_back(fmt::format(
          "The noise, {:.3g} {}, is that of poses which were measured again; how well the robot repeats is part of it.",
          *fit.noise, session.is_tracker() ? "m" : "px"));
  }
  if (declared && fit.noise_estimate && std::abs(fit.noise_estimate->sigma - *declared) > 3 * fit.noise_estimate->error)
    fit.notes.push_back(fmt::format(
        "The declared noise {:.3g} and the noise seen in the measurements {:.3g} +- {:.2g} {} differ by more than 3 "
        "sigma; check the declaration, or look for wrong corners and camera errors.",
        *declared, fit.noise_estimate->sigma, fit.noise_estimate->error, session.is_tracker() ? "m" : "px"));
}

/// Does the model agree with the measurements down to the noise (p > 1e-3)? Asked of the most efficient fit, images
/// with free markers: the other objectives leave more of the noise by their nature.
bool agrees_with_noise(const Problem& images, const NormalEquations& at_solution, bool declared, const Fit& fit) {
  if (!fit.noise || !(*fit.noise > 0)) return false;
  const bool is_own = fit.objective == Objective::image && !fit.fixed_markers;
  const std::optional<Solution> other = is_own ? std::nullopt : std::optional(solve(images, fit.solution.unknowns));
  int unknowns = static_cast<int>(images.columns()) - (other ? *other : fit.solution).unobservable;
  for (const char seen : images.marker_is_seen) unknowns -= seen ? 0 : 3;
  const NormalEquations& efficient = other ? other->normal : at_solution;
  const double cost = efficient.data_cost();
  const int degrees = efficient.rows - unknowns;
  if (degrees <= 0) return true;  // nothing speaks against it
  const double variance = *fit.noise * *fit.noise;
  if (!declared) {
    // The noise was estimated from part of these same residuals, with an error of its own: what is left of them over
    // is to be no larger (Fisher's F).
    const int extra = degrees - fit.noise_estimate->degrees;
    if (extra <= 0) return true;
    const double ratio = std::max(cost - variance * fit.noise_estimate->degrees, 0.0) / extra / variance;
    const boost::math::fisher_f expected(extra, fit.noise_estimate->degrees);
    return boost::math::cdf(boost::math::complement(expected, ratio)) > 1e-3;
  }
  const double chi2 = cost / variance;
  return boost::math::cdf(boost::math::complement(boost::math::chi_squared(degrees), chi2)) > 1e-3;
}

/// Covariances from the noise where the model fits, from the observations' scatter where it does not.
void set_covariances(const Problem& images, Loss loss, bool declared, Fit& fit) {
  const bool is_plain = fit.objective == Objective::image && loss == Loss::none;  // the minimum's own normal equations
  const NormalEquations at_solution = is_plain ? fit.solution.normal : normal_equations(images, fit.solution.unknowns);
  fit.rows = at_solution.rows;
  fit.unknowns = static_cast<int>(fit.solution.basis.cols()) - fit.solution.unobservable;
  for (const char seen : images.marker_is_seen)
    if (!seen && !fit.fixed_markers) fit.unknowns -= 3;
  const int degrees = fit.rows - fit.unknowns;
  fit.residual_rms = fit.rows > 0 ? std::sqrt(at_solution.data_cost() / fit.rows) : 0;
  const std::size_t count = fit.problem.observations.size();
  if (fit.noise && degrees > 0 && *fit.noise > 0)
    fit.chi2_per_dof = at_solution.data_cost() / (*fit.noise * *fit.noise) / degrees;
  const bool fits = agrees_with_noise(images, at_solution, declared, fit);
  fit.covariance_kind = fits ? CovarianceKind::noise : CovarianceKind::scatter;
  if (fit.objective == Objective::angle_axis) return;  // its own covariance, scaled below
  const double free_scale = degrees > 0 ? at_solution.data_cost() / degrees : 0.0;
  if (fits && fit.objective == Objective::image) {
    fit.parameter_covariance = *fit.noise * *fit.noise * unit_covariance(fit.solution);
  } else if (!fits && count >= fewest_for_scatter) {
    const double correction = static_cast<double>(count) / static_cast<double>(count - 1);
    fit.parameter_covariance =
        correction * sandwich_covariance(fit.solution, clustered_middle(fit.problem, fit.solution.unknowns));
  } else if (fit.objective == Objective::image) {
    fit.parameter_covariance = free_scale * unit_covariance(fit.solution);
  } else {
    fit.parameter_covariance =
        (fits ? *fit.noise * *fit.noise : free_scale) *
        sandwich_covariance(fit.solution, point_noise_middle(fit.problem, fit.solution.unknowns));
  }
}

/// A held shape has an error of its own: what of it the fit does not take up stays in the markers.
void add_shape_covariance(Fit& fit) {
  if (fit.shape_covariance.size() == 0) return;
  const Eigen::MatrixXd& b = fit.solution.basis;
  const Eigen::MatrixXd& h = fit.solution.normal.information;
  const Eigen::MatrixXd stays =
      Eigen::MatrixXd::Identity(h.rows(), h.cols()) - b * pseudo_inverse(b.transpose() * h * b) * b.transpose() * h;
  fit.parameter_covariance += stays * fit.shape_covariance * stays.transpose();
}

/// TCP->Body and effects explain the same measurements, so that their errors go together.
void add_effects_to_model_covariance(const Eigen::MatrixXd& xi_by_markers, Fit& fit) {
  const Eigen::MatrixXd& all = fit.parameter_covariance;
  const Eigen::Index first = fit.problem.effect_column(), markers = xi_by_markers.cols();
  const std::vector<Eigen::Index> first_of_term = first_numbers(fit.problem.terms, 6);
  fit.model_covariance.conservativeResizeLike(Eigen::MatrixXd::Zero(first_of_term.back(), first_of_term.back()));
  if (all.cols() < first + fit.problem.effect_count()) return;
  std::vector<Eigen::Index> places;  // of the columns among all numbers
  for (const EffectColumn& column : fit.problem.columns_of_effects)
    places.push_back(first_of_term[column.term] + static_cast<Eigen::Index>(column.parameter));
  for (std::size_t c = 0; c < places.size(); ++c) {
    const Eigen::Index from = first + static_cast<Eigen::Index>(c), to = places[c];
    const Vector6 with_body = xi_by_markers * all.col(from).head(markers);
    fit.model_covariance.col(to).head<6>() = with_body;
    fit.model_covariance.row(to).head<6>() = with_body.transpose();
    for (std::size_t d = 0; d < places.size(); ++d)
      fit.model_covariance(to, places[d]) = all(from, first + static_cast<Eigen::Index>(d));
  }
}

void set_body(const FitOptions& options, Fit& fit) {
  fit.sides = sides_of(options, fit.problem, fit.solution.unknowns);
  if (fit.sides.markers.empty()) return;
  const Matrix3 start = options.start_tcp_from_body ? options.start_tcp_from_body->rotation : Matrix3::Identity();
  const BodyFrame frame = body_frame(fit.sides, fit.solution.unknowns.markers_in_tcp, start);
  fit.tcp_from_body = frame.tcp_from_body;
  fit.rotation_is_observed = frame.unobserved.cols() == 0;
  const Eigen::Index markers = 3 * fit.problem.marker_count;
  fit.covariance = body_covariance(frame, fit.parameter_covariance.topLeftCorner(markers, markers));
  fit.model_covariance = fit.covariance;
  if (!fit.problem.terms.empty()) add_effects_to_model_covariance(frame.motion_by_markers, fit);
  const Rigid body_from_tcp = inverse(frame.tcp_from_body);
  for (const Vector3& x : fit.solution.unknowns.markers_in_tcp) fit.markers_in_body.push_back(body_from_tcp * x);
  if (!fit.rotation_is_observed)
    fit.notes.push_back(
        fmt::format("With {} the rotation of tcp_from_body is {} observable; what is not is left at its start value.",
                    fit.sides.markers.size() == 1 ? "one marker" : "two markers",
                    fit.sides.markers.size() == 1 ? "not" : "only partly"));
}

void add_notes(const Session& session, Fit& fit) {
  if (fit.problem.observations.size() == 1)
    fit.notes.push_back("Only one observation is used: tcp_from_body is that of thesis (4.35), and nothing checks it.");
  for (std::size_t m = 0; m < fit.problem.marker_is_seen.size(); ++m)
    if (!fit.problem.marker_is_seen[m])
      fit.notes.push_back(fmt::format("Marker {} is seen in no used observation and has no position.", m));
  if (fit.sightings_left_out > 0)
    fit.notes.push_back(fmt::format(
        "{} sightings by one camera only cannot take part in this objective, which needs triangulated points.",
        fit.sightings_left_out));
  if (fit.solution.unobservable > 0)
    fit.notes.push_back(
        fmt::format("{} direction{} of the unknowns cannot be observed in these poses and stay as they were.",
                    fit.solution.unobservable, fit.solution.unobservable == 1 ? "" : "s"));
  if (!fit.solution.converged)
    fit.notes.push_back(fmt::format("The fit did not converge in {} iterations.", fit.solution.iterations));
  for (const ProblemObservation& o : fit.problem.observations) {
    const Observation& observation = session.observations[static_cast<std::size_t>(o.index)];
    if (!o.springs_hold)
      fit.notes.push_back(
          fmt::format("Observation {}: the declared springs are too soft for the load.", observation.id));
  }
}

}  // namespace

namespace {

void refuse_cameras_of_points(const Session& session, const FitOptions& options, const Problem& images) {
  if (options.objective == Objective::image || options.estimated.empty()) return;
  const bool cameras = images.cameras_by_effect.cols() > 0;
  if (options.objective == Objective::camera && !cameras) return;
  throw InputError(fmt::format("{}: the {} objective cannot estimate {}; use the image objective.",
                               session_name(session), options.objective == Objective::camera ? "camera" : "angle-axis",
                               cameras ? "effects of the cameras" : "effects"));
}

/// What the priors of effects are weighed against: the noise, or where nothing is known of it the residuals.
void set_prior_noise(const Session& session, const Unknowns& start, Problem& images) {
  const auto declared = session.is_tracker() ? session.sigma_point : session.sigma_pixel;
  if (declared && *declared > 0) {
    images.noise = *declared;
    return;
  }
  auto estimated = estimate_noise(images, start);
  if (!estimated) estimated = noise_from_repeats(images, start);
  images.noise = estimated && estimated->sigma > 0 ? estimated->sigma : session.is_tracker() ? 1e-3 : 0.3;
}

/// Does a term move the body or its markers on the hand?
bool is_slip(const EffectTerm& term, const Chain& chain) {
  const Effect& effect = effect_of(term);
  if (effect.scope == EffectScope::marker) return true;
  if (effect.definition) {
    const std::vector<DefinedMove>& moves = effect.definition->moves;
    return std::any_of(moves.begin(), moves.end(), [](const DefinedMove& m) { return m.site.starts_with("body_"); });
  }
  const auto joints = static_cast<Eigen::Index>(chain.joints.size());
  EffectTerm one = term;
  std::fill(one.values.begin(), one.values.end(), 1.0);
  return !moved_sites(circumstances_at(chain, Eigen::VectorXd::Zero(joints)), {one}).body.isZero(0);
}

bool has_slip(const Problem& problem) {
  return std::any_of(problem.terms.begin(), problem.terms.end(),
                     [&](const EffectTerm& t) { return is_slip(t, problem.source->chain); });
}

/// Slips are measured in the body's frame, which follows from the markers: the frame is renewed until it stays.
void settle_slip_frame(const Session& session, const FitOptions& options, Problem& images, Fit& result) {
  if (!has_slip(images)) return;
  for (int pass = 0; pass < 5; ++pass) {
    const Unknowns& u = result.solution.unknowns;
    const BodySides sides = sides_of(options, result.problem, u);
    if (sides.markers.empty()) return;
    const Matrix3 start = options.start_tcp_from_body ? options.start_tcp_from_body->rotation : Matrix3::Identity();
    const Rigid tcp_from_body = body_frame(sides, u.markers_in_tcp, start).tcp_from_body;
    const Vector6 change = small_motion_between(images.tcp_from_slip, tcp_from_body);
    if (change.norm() < 1e-10) return;
    images.tcp_from_slip = result.problem.tcp_from_slip = tcp_from_body;
    set_effects(images, u.effects);
    set_effects(result.problem, u.effects);
    minimise(session, images, Unknowns(u), options, images.noise, result);
  }
}

/// A fit that its start has led nowhere is begun anew from the best of other starts; the cheapest end is kept.
void search_elsewhere(const Session& session, const FitOptions& options, const Problem& images, const Unknowns& start,
                      double noise, Fit& result) {
  const bool is_quick = options.least_gain > 0;
  if (is_quick || options.objective != Objective::image || !looks_lost(images, result.solution)) return;
  for (const Unknowns& other : competing_starts(images, start)) {
    Fit again = result;
    minimise(session, images, other, options, noise, again);
    const bool is_better = again.solution.normal.in_front >= result.solution.normal.in_front &&
                           again.solution.normal.cost < result.solution.normal.cost;
    if (is_better) result = std::move(again);
    if (!looks_lost(images, result.solution) || result.solution.stopped) return;
  }
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

}  // namespace

std::vector<EffectTerm> terms_of(const Fit& fit) {
  std::vector<EffectTerm> terms;
  for (const FittedEffect& e : fit.effects) terms.push_back(e.term);
  return terms;
}

Fit fit(const Session& session, const FitOptions& options) {
  const Chain chain = chain_of(session);
  Problem images = make_problem(session, chain, options.effects, options.estimated);
  if (images.observations.empty())
    throw InputError(
        fmt::format("{}: none of the {} observations has a labelled marker that may be used; label one first "
                    "(handsight-cli label).",
                    session_name(session), session.observations.size()));
  auto start = options.start ? options.start : start_values(images, session.mount);
  if (start) start->effects = effect_values(images);
  if (!start)
    throw InputError(fmt::format(
        "{}: nothing is known of the mount, and no marker is seen by both cameras, so that no start can be found; give "
        "mount_from_left an xyz and rpy.",
        session_name(session)));
  refuse_cameras_of_points(session, options, images);

  Fit result;
  result.objective = options.objective;
  result.fixed_markers = options.fix_markers || options.objective == Objective::angle_axis;
  if (images.effect_count() > 0) set_prior_noise(session, *start, images);
  if (!images.terms.empty()) {
    // A first frame for slips; settled below.
    std::vector<std::optional<Vector3>> markers(start->markers_in_tcp.begin(), start->markers_in_tcp.end());
    for (std::size_t m = 0; m < markers.size(); ++m)
      if (!images.marker_is_seen[m]) markers[m].reset();
    const BodySides sides = options.sides ? *options.sides : choose_sides(markers);
    if (!sides.markers.empty()) images.tcp_from_slip = body_frame(sides, start->markers_in_tcp).tcp_from_body;
    if (has_slip(images)) place_observations(images);
  }
  result.problem = options.objective == Objective::image ? images : as_points(images, result.sightings_left_out);
  if (result.problem.observations.empty())
    throw InputError(fmt::format(
        "{}: no marker is seen by both cameras in any used observation, which the {} objective needs; use the image "
        "objective.",
        session_name(session), options.objective == Objective::camera ? "camera" : "angle-axis"));
  if (options.objective == Objective::camera) result.problem.noise = 1e-3;  // points: m
  const double declared = session.is_tracker() ? session.sigma_point.value_or(1) : session.sigma_pixel.value_or(1);
  minimise(session, images, *start, options, declared, result);
  search_elsewhere(session, options, images, *start, declared, result);
  settle_slip_frame(session, options, images, result);
  if (images.effect_count() > 0) {
    set_effects(images, result.solution.unknowns.effects);
    set_effects(result.problem, result.solution.unknowns.effects);
  }
  set_noise(session, images, result);
  set_covariances(images, options.loss, (session.is_tracker() ? session.sigma_point : session.sigma_pixel).has_value(),
                  result);
  add_shape_covariance(result);
  set_body(options, result);
  set_effect_results(options.effects.size(), result);
  add_notes(session, result);
  return result;
}

}  // namespace handsight
