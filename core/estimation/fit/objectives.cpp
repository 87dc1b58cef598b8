// SPDX-License-Identifier: Apache-2.0
#include "estimation/fit/objectives.h"

#include "chain/sighting.h"
#include "estimation/fit/angle_axis.h"
#include "estimation/problem/body_shape.h"
#include "estimation/solvers/covariance_factor.h"
#include "estimation/solvers/normal_equations.h"
#include "estimation/solvers/trust_region.h"
#include "estimation/start/shape_start.h"

namespace handsight {
namespace {

/// The average shape laid onto the start's markers: where the body is held rigid from. `covariance` becomes that of the
/// held markers, by the problem's columns. Nothing where no observation shows three markers as points.
std::optional<Unknowns> with_average_shape(const Problem& images, const Unknowns& start, Eigen::MatrixXd& covariance) {
  const auto shape = average_shape(images);
  if (!shape) return std::nullopt;
  Eigen::Matrix3Xd in_tcp(3, images.marker_count), in_shape(3, images.marker_count);
  Eigen::VectorXd weights(images.marker_count);
  for (int m = 0; m < images.marker_count; ++m) {
    const auto i = static_cast<std::size_t>(m);
    in_tcp.col(m) = start.markers_in_tcp[i];
    in_shape.col(m) = shape->markers[i];
    weights[m] = shape->is_known[i] && images.marker_is_seen[i] ? 1 : 0;
  }
  const Rigid tcp_from_shape = align_points(in_tcp, in_shape, weights);
  Unknowns unknowns = start;
  covariance = Eigen::MatrixXd::Zero(images.columns(), images.columns());
  for (int m = 0; m < images.marker_count; ++m) {
    if (!(weights[m] > 0)) continue;
    const auto i = static_cast<std::size_t>(m);
    unknowns.markers_in_tcp[i] = tcp_from_shape * Vector3(in_shape.col(m));
    covariance.block<3, 3>(3 * m, 3 * m) =
        tcp_from_shape.rotation * shape->covariances[i] * tcp_from_shape.rotation.transpose();
  }
  return unknowns;
}

/// The markers as the body that is held: as it is known, else as the observations have it on average.
std::optional<Unknowns> with_held_shape(const Problem& images, const Unknowns& start, Eigen::MatrixXd& covariance) {
  if (images.has_shape_prior() && images.shape->piece_count() == 1) return laid_onto(*images.shape, start);
  return with_average_shape(images, start, covariance);
}

SolveOptions solve_options(const FitOptions& options, const Fit& fit, bool fixed_body) {
  return {.fixed_body = fixed_body,
          .most_iterations = options.most_iterations,
          .smallest_step = options.smallest_step,
          .least_gain = options.least_gain,
          .reuse_below = options.reuse_below,
          .loss = options.loss,
          .noise = fit.loss_noise,
          .on_iteration = options.on_iteration};
}

/// Effects, and losses with their flat flanks, bend the cost: a whole fit of them is Ceres'. Where a quick answer is
/// asked for, and where nothing bends, our own equations come first; where they do not get there, Ceres goes on.
Solution minimum(const Problem& problem, const Unknowns& start, const SolveOptions& options) {
  const bool is_quick = options.least_gain > 0 || options.reuse_below > 0;
  const bool is_plain = problem.flange_error.is_any() || (problem.effect_count() == 0 && options.loss == Loss::none);
  if (!is_quick && !is_plain) return solve_by_trust_region(problem, start, options);
  Solution ours = solve(problem, start, options);
  if (ours.converged || ours.stopped || problem.flange_error.is_any()) return ours;
  const bool is_rough = options.least_gain > 0;  // what is left to gain is not worth a second search
  if (is_rough && ours.normal.in_front && ours.normal.cost < ours.start_cost) return ours;
  Solution farther = solve_by_trust_region(problem, ours.unknowns, options);
  farther.iterations += ours.iterations;
  farther.start_cost = ours.start_cost;
  return farther.normal.cost <= ours.normal.cost ? farther : ours;
}

/// The angle-axis minimum as the solution of a problem, so that every other part of the program reads it alike. The
/// body frame there is that of the markers as they stand in `unknowns`, taken as the TCP frame moved by nothing.
std::optional<AngleAxisResult> angle_axis_step(const Problem& problem, const Unknowns& unknowns, double noise,
                                               Loss loss) {
  return fit_angle_axis(problem, unknowns.markers_in_tcp, Rigid{}, unknowns.mount_from_sensor, noise, loss);
}

Unknowns moved_body(const Unknowns& unknowns, const AngleAxisResult& result) {
  Unknowns next = unknowns;
  for (Vector3& x : next.markers_in_tcp) x = result.tcp_from_body * x;
  next.mount_from_sensor = result.mount_from_sensor;
  return next;
}

}  // namespace

void minimise(const Session& session, const Problem& images, const Unknowns& start, const FitOptions& options,
              double noise, Fit& fit) {
  const std::optional<Unknowns> held = fit.fixed_markers ? with_held_shape(images, start, fit.shape_covariance) : start;
  if (!held)
    throw InputError(message(
        "{}: holding the markers fixed needs an observation that shows three of them as points (two cameras, or a "
        "tracker), and there is none; fit with free markers.",
        session.file.filename().string()));
  const Unknowns& from = *held;
  if (options.objective != Objective::angle_axis) {
    fit.solution = minimum(fit.problem, from, solve_options(options, fit, fit.fixed_markers));
    return;
  }
  // The image fit of the held body is the start: its poses are where the single observations are looked for.
  fit.solution = minimum(images, from, solve_options(options, fit, true));
  fit.problem = images;
  const auto result = angle_axis_step(images, fit.solution.unknowns, noise, options.loss);
  if (!result)
    throw InputError(message(
        "{}: the angle-axis objective needs observations with three markers or more ({} of them); use the image "
        "objective.",
        session.file.filename().string(), images.mount_is_estimated ? "three" : "one"));
  fit.solution.unknowns = moved_body(fit.solution.unknowns, *result);
  fit.solution.converged = result->converged;
  fit.angle_axis_sigma_m = result->sigma_m;
  fit.angle_axis_sigma_rad = result->sigma_rad;
  Eigen::MatrixXd basis = Eigen::MatrixXd::Zero(images.columns(), result->covariance_factor.rows());
  for (int m = 0; m < images.marker_count; ++m) {
    basis.block<3, 3>(3 * m, 0) = Matrix3::Identity();
    basis.block<3, 3>(3 * m, 3) = -cross_matrix(fit.solution.unknowns.markers_in_tcp[static_cast<std::size_t>(m)]);
  }
  basis.bottomRightCorner(images.columns() - 3 * images.marker_count, result->covariance_factor.rows() - 6)
      .setIdentity();
  fit.parameter_covariance = covariance_from(basis * result->covariance_factor);
}

Unknowns refit(const Fit& fit, const FitOptions& options, const Problem& part, double noise) {
  FitOptions quiet = options;
  quiet.on_iteration = nullptr;
  Unknowns from = fit.solution.unknowns;
  if (fit.fixed_markers) {  // the shape of these observations alone: the others must not have told it
    Eigen::MatrixXd not_read;
    if (auto held = with_held_shape(part, from, not_read)) from = std::move(*held);
  }
  if (options.objective != Objective::angle_axis)
    return solve(part, from, solve_options(quiet, fit, fit.fixed_markers)).unknowns;
  const auto result = angle_axis_step(part, from, noise, options.loss);
  return result ? moved_body(from, *result) : from;
}

Eigen::MatrixXd point_noise_middle(const Problem& points, const Unknowns& unknowns) {
  Eigen::MatrixXd middle = Eigen::MatrixXd::Zero(points.columns(), points.columns());
  for (const ProblemObservation& o : points.observations) {
    const Rigid sensor_from_tcp = sensor_from_tcp_at(o, unknowns);
    for (std::size_t i = 0; i < o.sightings.size(); ++i) {
      const Eigen::Index m = 3 * o.sightings[i].marker;
      const Vector3 x = sensor_from_tcp * marker_at(o, unknowns, o.sightings[i].marker);
      Eigen::MatrixXd by = Eigen::MatrixXd::Zero(3, points.columns());
      by.middleCols<3>(m) = sensor_from_tcp.rotation;
      by.rightCols(points.columns() - points.mount_column()) =
          by_motion(Matrix3(Matrix3::Identity()), x) * motion_by_columns(points, o, unknowns);
      middle +=
          by.transpose() * (o.point_covariances.empty() ? Matrix3(Matrix3::Identity()) : o.point_covariances[i]) * by;
    }
  }
  return middle;
}

}  // namespace handsight
