// SPDX-License-Identifier: Apache-2.0
#include "estimation/solvers/trust_region.h"

#include <ceres/ceres.h>
#include <glog/logging.h>

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <map>

#include "estimation/solvers/inverse_parts.h"
#include "estimation/solvers/prior_costs.h"
#include "estimation/solvers/priors.h"
#include "estimation/solvers/unknown_steps.h"

namespace handsight {
namespace {

/// Measured - predicted of one sighting in units of the noise; its blocks are the marker or the body, the mount where
/// it is estimated, the effects where there are any.
class SightingCost : public ceres::CostFunction {
 public:
  SightingCost(const TriedPlace& place, std::size_t observation, std::size_t sighting, double weight)
      : place_(place), observation_(observation), sighting_(sighting), weight_(weight) {
    set_num_residuals(row_count(seen()));
    mutable_parameter_block_sizes()->push_back(place.is_fixed_body ? 12 : 3);
    if (place.is_free(place.mount_at(observation))) mutable_parameter_block_sizes()->push_back(12);
    if (place.effects.size() > 0) mutable_parameter_block_sizes()->push_back(static_cast<int>(place.effects.size()));
  }

  bool Evaluate(double const* const*, double* residuals, double** jacobians) const override {
    const ProblemObservation& o = place_.problem.observations[observation_];
    const Rigid& sensor_from_tcp = place_.sensor_from_tcp[observation_];
    const Vector3 in_tcp = marker_at(o, place_.unknowns, seen().marker);
    const Vector3 x = sensor_from_tcp * in_tcp;
    const SightingResidual r = sighting_residual(place_.problem.rig_or_null(), seen(), x);
    const bool is_finite = r.error.allFinite() && r.by_point.allFinite();
    constexpr double far_off = 1e10;  // no place to stand; a number that is none would end the search
    for (int row = 0; row < r.rows; ++row) residuals[row] = is_finite ? weight_ * r.error[row] : far_off;
    if (jacobians) set_jacobians(o, r, x, sensor_from_tcp.rotation, is_finite ? -weight_ : 0.0, jacobians);
    return true;
  }

 private:
  const Sighting& seen() const { return place_.problem.observations[observation_].sightings[sighting_]; }

  void set_jacobians(const ProblemObservation& o, const SightingResidual& r, const Vector3& x, const Matrix3& rotation,
                     double sign, double** jacobians) const {
    const Problem& p = place_.problem;
    const SightingRows<3> by_point = sign == 0 ? SightingRows<3>::Zero(r.rows, 3).eval() : (sign * r.by_point).eval();
    const SightingRows<6> by_sensor = by_motion(by_point, x);
    int block = 0;
    if (double* by_body = jacobians[block++]) {
      if (place_.is_fixed_body) {
        Eigen::Matrix<double, 3, 6> marker_by_step;
        marker_by_step << Matrix3::Identity(),
            -cross_matrix(place_.unknowns.markers_in_tcp[static_cast<std::size_t>(seen().marker)]);
        Rows(by_body, r.rows, 12) = by_point * rotation * marker_by_step * place_.body_step_by_numbers;
      } else {
        Rows(by_body, r.rows, 3) = by_point * rotation;
      }
    }
    const auto& motion = place_.motions[observation_];
    if (const Eigen::Index mount = p.column_of_mount(o.mount); mount >= 0)
      if (double* by_mount = jacobians[block++])
        Rows(by_mount, r.rows, 12) = by_sensor * motion.middleCols<6>(mount - p.mount_column()) *
                                     place_.mount_steps_by_numbers[place_.mount_at(observation_)];
    if (p.effect_count() == 0) return;
    double* by_effects = jacobians[block];
    if (!by_effects) return;
    Rows rows(by_effects, r.rows, p.effect_count());
    rows.noalias() = by_sensor * motion.rightCols(p.effect_count());
    if (p.cameras_by_effect.cols() > 0 || !o.motion.markers.empty())
      rows += sign * direct_by_effects(p, o, seen(), r, x, rotation);
    for (Eigen::Index i = 0; i < p.effect_count(); ++i) rows.col(i) *= place_.sigma(i);
  }

  const TriedPlace& place_;
  std::size_t observation_, sighting_;
  double weight_;
};

/// Told of every step; ends the search where that wants it, or where a step has gained too little.
class Watch : public ceres::IterationCallback {
 public:
  Watch(const SolveOptions& options, TriedPlace& place, double unit) : options_(options), place_(place), unit_(unit) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& s) override {
    if (s.iteration == 0 || !s.step_is_successful) return ceres::SOLVER_CONTINUE;
    place_.read();
    stopped = options_.on_iteration && !options_.on_iteration(s.iteration, 2 * unit_ * unit_ * s.cost, place_.unknowns);
    if (stopped) return ceres::SOLVER_TERMINATE_SUCCESSFULLY;
    const bool gains_nothing = 2 * unit_ * unit_ * s.cost_change < options_.least_gain;
    return gains_nothing ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE;
  }
  bool stopped = false;

 private:
  const SolveOptions& options_;
  TriedPlace& place_;
  double unit_;
};

ceres::LossFunction* loss_function(Loss loss, double limit) {
  if (loss == Loss::huber) return new ceres::HuberLoss(limit);
  return loss == Loss::cauchy ? new ceres::CauchyLoss(limit) : nullptr;
}

void add_sightings(TriedPlace& place, const SolveOptions& options, double unit, ceres::Problem& squares) {
  std::map<int, ceres::LossFunction*> losses;  // by rows; the problem owns them
  const Problem& p = place.problem;
  for (std::size_t k = 0; k < p.observations.size(); ++k)
    for (std::size_t i = 0; i < p.observations[k].sightings.size(); ++i) {
      const ProblemObservation& o = p.observations[k];
      const int rows = row_count(o.sightings[i]);
      if (rows == 0) continue;
      std::vector<double*> blocks{
          place.is_fixed_body ? place.body.data()
                              : place.unknowns.markers_in_tcp[static_cast<std::size_t>(o.sightings[i].marker)].data()};
      if (place.is_free(place.mount_at(k))) blocks.push_back(place.mounts[place.mount_at(k)].data());
      if (place.effects.size() > 0) blocks.push_back(place.effects.data());
      if (options.loss != Loss::none && !losses.contains(rows))
        losses[rows] = loss_function(options.loss, tuning_constant(rows) * options.noise / unit);
      const bool weighted = options.loss == Loss::none && !o.weights.empty();
      squares.AddResidualBlock(new SightingCost(place, k, i, (weighted ? std::sqrt(o.weights[i]) : 1.0) / unit),
                               options.loss == Loss::none ? nullptr : losses[rows], blocks);
    }
}

ceres::Solver::Options solver_options(const SolveOptions& options, Watch& watch) {
  ceres::Solver::Options o;
  o.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
  o.num_threads = 1;
  o.max_num_iterations = options.most_iterations;
  // Near the answer a step is Newton's; far from it the region is found in a few evaluations without derivatives.
  o.initial_trust_region_radius = 1e8;
  o.max_trust_region_radius = 1e12;
  o.function_tolerance = 1e-15;
  o.gradient_tolerance = 1e-300;
  o.parameter_tolerance = options.smallest_step;
  o.logging_type = ceres::SILENT;
  o.callbacks.push_back(&watch);
  o.update_state_every_iteration = true;
  return o;
}

/// A plate may turn about its normal and shift in itself: what that does to a touch is rounding, and steps along it are
/// held small by what the squares of the others' derivatives by far exceed.
constexpr double least_of_touches = 1e4;

}  // namespace

Solution solve_by_trust_region(const Problem& problem, const Unknowns& start, const SolveOptions& options) {
  FLAGS_minloglevel = google::GLOG_FATAL;  // core never prints
  const double unit = problem.noise > 0 ? problem.noise : 1;
  Unknowns from = start;
  if (from.effects.size() != problem.effect_count()) from.effects = effect_values(problem);
  TriedPlace place(problem, from, options);
  ceres::Problem::Options ownership;
  ownership.evaluation_callback = &place;
  ownership.manifold_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem squares(ownership);
  add_sightings(place, options, unit, squares);
  add_mount_priors(place, squares);
  for (std::size_t i = 0; i < place.mounts.size(); ++i)
    if (!place.is_free(i) && squares.HasParameterBlock(place.mounts[i].data()))
      squares.SetParameterBlockConstant(place.mounts[i].data());
  for (MotionNumbers& mount : place.mounts)
    if (squares.HasParameterBlock(mount.data())) squares.SetManifold(mount.data(), &place.mount_manifold);
  if (place.is_fixed_body && squares.HasParameterBlock(place.body.data()))
    squares.SetManifold(place.body.data(), &place.body_manifold);
  add_priors(place, squares);
  Watch watch(options, place, unit);
  ceres::Solver::Summary summary;
  ceres::Solver::Options how = solver_options(options, watch);
  if (has_fixtures(problem)) how.min_lm_diagonal = least_of_touches;
  ceres::Solve(how, &squares, &summary);

  place.read();
  Solution solution;
  solution.unknowns = place.unknowns;
  solution.iterations = static_cast<int>(summary.iterations.size()) - 1;
  solution.stopped = watch.stopped;
  solution.start_cost = 2 * unit * unit * summary.initial_cost;
  if (problem.effect_count() > 0) set_effects(place.problem, solution.unknowns.effects);
  solution.normal = weighted_normal_equations(place.problem, solution.unknowns, options.loss, options.noise);
  const bool ended = summary.termination_type == ceres::CONVERGENCE || summary.termination_type == ceres::USER_SUCCESS;
  solution.converged = ended && !solution.stopped && solution.normal.in_front && std::isfinite(solution.normal.cost);
  solution.basis = step_basis(problem, solution.unknowns, options.fixed_body);
  pseudo_inverse(solution.basis.transpose() * solution.normal.information * solution.basis, &solution.unobservable);
  return solution;
}

}  // namespace handsight
