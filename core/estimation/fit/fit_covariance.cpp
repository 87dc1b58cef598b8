// SPDX-License-Identifier: Apache-2.0
#include "estimation/fit/fit_covariance.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

#include "chain/unknown_angle.h"
#include "estimation/fit/noise.h"
#include "estimation/fit/objectives.h"
#include "estimation/problem/column_products.h"
#include "estimation/problem/robot_scale.h"
#include "estimation/solvers/covariance_factor.h"
#include "estimation/solvers/inverse_parts.h"
#include "estimation/solvers/normal_equations.h"
#include "estimation/solvers/priors.h"
#include "estimation/solvers/unit_factor.h"
#include "estimation/solvers/unknown_steps.h"

namespace handsight {
namespace {

constexpr double agreement = 1e-3;  // the least probability of what is left, were it noise

/// Of the unknowns, how many their priors know: tr(P H^-1). The measurements know the rest, tr(H_data H^-1).
double known_by_priors(const Problem& problem, const Unknowns& unknowns, const Eigen::MatrixXd& inverse) {
  double known = 0;
  if (problem.has_shape_prior()) {
    const Eigen::MatrixXd prior = shape_prior(problem, unknowns.markers_in_tcp).information;
    known += prior.cwiseProduct(inverse.topLeftCorner(prior.rows(), prior.cols())).sum();
  }
  for (Eigen::Index i = 0; i < problem.effect_count(); ++i) {
    const double sigma = problem.columns_of_effects[static_cast<std::size_t>(i)].prior_sigma();
    const Eigen::Index column = problem.effect_column() + i;
    known += std::pow(problem.noise / sigma, 2) * inverse(column, column);
  }
  if (learns_from_camera_images(problem)) {
    const Eigen::Index at = problem.effect_column(), count = problem.effect_count();
    const Eigen::MatrixXd reported = camera_prior(problem).information;
    known += problem.noise * problem.noise * reported.cwiseProduct(inverse.block(at, at, count, count)).sum();
  }
  if (holds_robot_scale(problem)) {
    const Eigen::VectorXd& scale = problem.robot_scale->by_effect;
    known +=
        std::pow(problem.noise / robot_scale_sigma, 2) *
        scale.dot(inverse.block(problem.effect_column(), problem.effect_column(), scale.size(), scale.size()) * scale);
  }
  return known;
}

/// Numbers of fixtures' places that mean nothing, a plane's turn about its normal: no touch moves with them.
int meaningless(const Problem& problem, const Solution& solution) {
  if (!has_fixtures(problem) || solution.basis.cols() != problem.columns()) return 0;
  const Eigen::VectorXd scale = inverse_scale(solution.normal.information);
  return static_cast<int>((scale.segment(problem.mount_column(), problem.mount_columns()).array() == 0).count());
}

/// Effective number of unknowns that a solution takes from the measurements; `inverse` is its unit covariance.
int unknowns_of(const Problem& problem, const Solution& solution, const Eigen::MatrixXd& inverse, bool fixed_markers) {
  int count = static_cast<int>(solution.basis.cols()) - solution.unobservable - meaningless(problem, solution);
  for (const char seen : problem.marker_is_seen)
    if (!seen && !fixed_markers && !problem.has_shape_prior()) count -= 3;
  return count - static_cast<int>(std::lround(known_by_priors(problem, solution.unknowns, inverse)));
}

/// A prior is one more measurement, with its own scatter: gathers the gradients of these, a row each, times
/// `by_columns`, which has a row for each of the problem's columns.
void add_prior_repeatability(const Problem& problem, const Unknowns& unknowns, const Eigen::MatrixXd& by_columns,
                             GatheredRows& gathered) {
  const Eigen::Index effects = problem.effect_count();
  if (problem.has_shape_prior()) {
    const Eigen::MatrixXd rows = shape_prior_rows(problem, unknowns.markers_in_tcp).by_markers;
    gathered.add(problem.noise * rows * by_columns.topRows(rows.cols()));
  }
  for (Eigen::Index i = 0; i < effects; ++i) {
    const double sigma = problem.columns_of_effects[static_cast<std::size_t>(i)].prior_sigma();
    gathered.add(problem.noise / sigma * problem.noise * by_columns.row(problem.effect_column() + i));
  }
  if (learns_from_camera_images(problem))
    gathered.add(problem.noise * problem.noise * make_factor(camera_prior(problem).information).transpose() *
                 by_columns.middleRows(problem.effect_column(), effects));
  if (holds_robot_scale(problem))
    gathered.add(problem.noise / robot_scale_sigma * problem.noise * problem.robot_scale->by_effect.transpose() *
                 by_columns.middleRows(problem.effect_column(), effects));
}

/// A factor of the covariance by the outer products of the observations' gradients: how much observations differ,
/// whatever the cause. Each gradient is taken along directions that are known as little as one another, see
/// sandwich_factor.
Eigen::MatrixXd clustered_factor(const Problem& problem, const Unknowns& unknowns, const Eigen::MatrixXd& unit) {
  Eigen::MatrixXd middle = Eigen::MatrixXd::Zero(unit.cols(), unit.cols());
  GatheredRows gathered(middle, static_cast<Eigen::Index>(problem.observations.size()));
  for (const ProblemObservation& o : problem.observations)
    gathered.add(compute_gradient(problem, o, unknowns).transpose() * unit);
  add_prior_repeatability(problem, unknowns, unit, gathered);
  gathered.settle();
  return unit * make_factor(middle.selfadjointView<Eigen::Lower>());
}

/// Two moments of a robust loss at the solution, by the problem's columns.
struct LossMoments {
  Eigen::MatrixXd curvature;  // of half the cost: J^T (rho' + 2 rho'' e e^T) J and the priors
  Eigen::MatrixXd scores;     // sum over sightings of (J^T rho' e) (J^T rho' e)^T and the priors'
};

LossMoments loss_moments(Problem& problem, const Unknowns& unknowns, Loss loss, double noise) {
  LossMoments moments;
  moments.curvature = weighted_normal_equations(problem, unknowns, loss, noise).information;
  moments.scores = Eigen::MatrixXd::Zero(problem.columns(), problem.columns());
  for (ProblemObservation o : problem.observations) {
    const std::vector<Sighting> sightings = std::move(o.sightings);
    for (std::size_t i = 0; i < sightings.size(); ++i) {
      o.sightings = {sightings[i]};
      o.weights = {1.0};
      NormalEquations one(problem.columns());
      add_observation(problem, o, unknowns, one);
      const LossValue value = loss_at(loss, one.cost, one.rows, noise);
      moments.curvature += 2 * value.curvature * one.gradient * one.gradient.transpose();
      moments.scores += value.weight * value.weight * one.gradient * one.gradient.transpose();
    }
  }
  GatheredRows gathered(moments.scores);
  add_prior_repeatability(problem, unknowns, Eigen::MatrixXd::Identity(problem.columns(), problem.columns()), gathered);
  gathered.settle();
  moments.scores.triangularView<Eigen::StrictlyUpper>() = moments.scores.transpose();
  return moments;
}

/// Is what free markers would leave, by the equations at the solution, ten times what could be noise? It saves most of
/// the time in which they are fitted.
bool is_far_from_noise(const Problem& images, const Fit& fit, double estimated) {
  constexpr double tenth = 0.1;
  const NormalEquations normal = normal_equations(images, fit.solution.unknowns);
  const double gain = normal.gradient.dot(damped_step(normal.information, normal.gradient, 1e-8));
  const double squares = tenth * (normal.data_cost() - gain) / (*fit.noise * *fit.noise);
  const auto test = noise_test(squares, normal.rows, estimated);
  return test && test->p < agreement;
}

/// Does the model agree with the measurements down to the noise? Asked of the most efficient fit, images with free
/// markers: the other objectives leave more of the noise by their nature.
bool agrees_with_noise(const Problem& images, const NormalEquations& at_solution, bool declared, const Fit& fit) {
  if (!fit.noise || !(*fit.noise > 0)) return false;
  const double estimated = declared ? 0 : fit.noise_estimate->degrees;
  const bool is_own = fit.objective == Objective::image && !fit.fixed_markers;
  if (!is_own && is_far_from_noise(images, fit, estimated)) return false;
  const std::optional<Solution> other = is_own ? std::nullopt : std::optional(solve(images, fit.solution.unknowns));
  const int unknowns = other ? unknowns_of(images, *other, unit_covariance(*other), false) : fit.unknowns;
  const NormalEquations& efficient = other ? other->normal : at_solution;
  const double squares = efficient.data_cost() / (*fit.noise * *fit.noise);
  const auto test = noise_test(squares, efficient.rows - unknowns, estimated);
  return !test || test->p > agreement;  // where nothing is left, nothing speaks against it
}

/// The least of what a factor says of a number of a marker's place; 1 where it says nothing.
double least_sigma_of_markers(const Problem& problem, const Eigen::MatrixXd& factor) {
  double least = 0;
  for (Eigen::Index i = 0; i < 3 * problem.marker_count; ++i)
    if (const double sigma = factor.row(i).norm(); sigma > 0 && (least == 0 || sigma < least)) least = sigma;
  return least > 0 ? least : 1;
}

/// What the scatter of observations about a fit is drawn out by: they are few, and the fit has followed them
/// (Cameron and Miller 2015, A practitioner's guide to cluster-robust inference, eq. 11).
double repeatability_correction(const Fit& fit) {
  const auto observations = static_cast<double>(fit.problem.observations.size());
  return observations / (observations - 1) * (fit.rows - 1) / std::max(fit.rows - fit.unknowns, 1);
}

/// With a loss: its curvature about the moment of its scores, of sightings where the noise is all that differs, of
/// observations where more does.
Eigen::MatrixXd loss_factor(const FitOptions& options, bool fits, const Fit& fit) {
  Problem weighted = fit.problem;
  const LossMoments moments = loss_moments(weighted, fit.solution.unknowns, options.loss, fit.loss_noise);
  Solution curved = fit.solution;
  curved.normal.information = moments.curvature;
  const Eigen::MatrixXd unit = unit_factor(curved);
  if (fits || fit.problem.observations.size() < fewest_for_repeatability) return sandwich_factor(unit, moments.scores);
  return std::sqrt(repeatability_correction(fit)) * clustered_factor(weighted, fit.solution.unknowns, unit);
}

}  // namespace

/// The problem as though the robot told no untruth: whose residuals are the images'.
static Problem without_flange_error(Problem problem) {
  problem.flange_error = {};
  return problem;
}

/// The sizes of the robot's error are themselves found from few poses, six numbers each, which they share: what a
/// normal distribution would leave has Student's tails. Times so much variance its 95 % interval is Student's.
static double as_few_poses_tell(const Fit& fit) {
  constexpr double sizes = 2, fewest_degrees = 3, within = 0.975;
  const double degrees =
      (6.0 * static_cast<double>(fit.problem.observations.size()) - static_cast<double>(fit.unknowns)) / sizes;
  const boost::math::students_t student(std::max(degrees, fewest_degrees));
  return std::pow(boost::math::quantile(student, within) / boost::math::quantile(boost::math::normal(), within), 2);
}

Eigen::MatrixXd covariance_factor(const Problem& images, const FitOptions& options, bool declared, Fit& fit) {
  const bool robot_errs = fit.problem.flange_error.is_any();
  const bool is_plain = fit.objective == Objective::image && options.loss == Loss::none && !robot_errs;
  // The minimum's own normal equations are those of the images without weights.
  const std::optional<Problem> as_reported = robot_errs ? std::optional(without_flange_error(images)) : std::nullopt;
  const Problem& seen = as_reported ? *as_reported : images;
  const NormalEquations at_solution = is_plain ? fit.solution.normal : normal_equations(seen, fit.solution.unknowns);
  const Eigen::MatrixXd unit = unit_factor(fit.solution);
  fit.rows = at_solution.rows;
  fit.unknowns = unknowns_of(fit.problem, fit.solution, covariance_from(unit), fit.fixed_markers);
  const int degrees = fit.rows - fit.unknowns;
  fit.residual_rms = fit.rows > 0 ? std::sqrt(at_solution.data_cost() / fit.rows) : 0;
  const std::size_t count = fit.problem.observations.size();
  if (fit.noise && degrees > 0 && *fit.noise > 0)
    fit.chi2_per_dof = at_solution.data_cost() / (*fit.noise * *fit.noise) / degrees;
  const bool fits = agrees_with_noise(seen, at_solution, declared, fit);
  fit.covariance_kind = fits ? CovarianceKind::noise : CovarianceKind::repeatability;
  if (fit.objective == Objective::angle_axis) return make_factor(fit.parameter_covariance);  // has its own
  if (options.loss != Loss::none) return loss_factor(options, fits, fit);
  if (robot_errs) return std::sqrt(as_few_poses_tell(fit)) * fit.problem.noise * unit;
  if (is_accuracy_unknown(fit)) return unknown_length / least_sigma_of_markers(fit.problem, unit) * unit;
  const double free_scale = degrees > 0 ? std::sqrt(at_solution.data_cost() / degrees) : 0.0;
  if (fits && fit.objective == Objective::image) return *fit.noise * unit;
  if (!fits && count >= fewest_for_repeatability)
    return std::sqrt(repeatability_correction(fit)) * clustered_factor(fit.problem, fit.solution.unknowns, unit);
  if (fit.objective == Objective::image) return free_scale * unit;
  return (fits ? *fit.noise : free_scale) *
         sandwich_factor(unit, point_noise_middle(fit.problem, fit.solution.unknowns));
}

bool is_accuracy_unknown(const Fit& fit) { return has_fixtures(fit.problem) && !fit.noise && fit.rows <= fit.unknowns; }

void add_shape_columns(const Fit& fit, Eigen::MatrixXd& factor) {
  if (fit.shape_covariance.size() == 0) return;
  const Eigen::MatrixXd& b = fit.solution.basis;
  const Eigen::MatrixXd& h = fit.solution.normal.information;
  const Eigen::MatrixXd stays =
      Eigen::MatrixXd::Identity(h.rows(), h.cols()) - b * pseudo_inverse(b.transpose() * h * b) * b.transpose() * h;
  factor.conservativeResize(Eigen::NoChange, factor.cols() + h.cols());
  factor.rightCols(h.cols()) = stays * make_factor(fit.shape_covariance);
}

}  // namespace handsight
