// SPDX-License-Identifier: Apache-2.0
#include "estimation/solvers/trust_region.h"

#include <ceres/ceres.h>
#include <glog/logging.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <array>
#include <cmath>
#include <map>

#include "estimation/problem/robot_scale.h"
#include "estimation/solvers/motion_manifold.h"
#include "estimation/solvers/priors.h"

namespace handsight {
namespace {

/// The problem at the unknowns that Ceres tries; all sightings read their places from here.
class Place : public ceres::EvaluationCallback {
 public:
  Place(const Problem& original, const Unknowns& start, const SolveOptions& options)
      : problem(original),
        unknowns(start),
        is_fixed_body(options.fixed_body),
        body(numbers_of(Rigid{})),
        effects(start.effects.size()),
        start_(start) {
    for (Eigen::Index i = 0; i < effects.size(); ++i) effects[i] = start.effects[i] / sigma(i);
    for (int i = 0; i < problem.mount_count(); ++i) mounts.push_back(numbers_of(start.mount(i)));
    mount_steps_by_numbers.resize(mounts.size());
    motions.resize(problem.observations.size());
    sensor_from_tcp.resize(problem.observations.size());
  }

  double sigma(Eigen::Index effect) const {
    return problem.columns_of_effects[static_cast<std::size_t>(effect)].prior_sigma();
  }

  void PrepareForEvaluation(bool evaluate_jacobians, bool new_point) override {
    read();
    const bool lacks = evaluate_jacobians && !derives_;
    if (!new_point && !lacks) return;
    if (problem.effect_count() > 0) place_effects(evaluate_jacobians);
    derives_ = evaluate_jacobians;
    for (std::size_t k = 0; k < problem.observations.size(); ++k) {
      const ProblemObservation& o = problem.observations[k];
      sensor_from_tcp[k] = sensor_from_tcp_at(o, unknowns);
      if (evaluate_jacobians) motions[k] = motion_by_columns(problem, o, unknowns);
    }
    if (!evaluate_jacobians) return;
    for (std::size_t i = 0; i < mounts.size(); ++i)
      if (is_free(i)) mount_steps_by_numbers[i] = mount_manifold.step_by_numbers(mounts[i].data());
    if (is_fixed_body) body_step_by_numbers = body_manifold.step_by_numbers(body.data());
  }

  /// The unknowns of Ceres' numbers.
  void read() {
    for (Eigen::Index i = 0; i < effects.size(); ++i) unknowns.effects[i] = effects[i] * sigma(i);
    for (std::size_t i = 0; i < mounts.size(); ++i)
      if (is_free(i)) unknowns.mount(static_cast<int>(i)) = motion_of(mounts[i].data());
    if (!is_fixed_body) return;
    for (std::size_t m = 0; m < unknowns.markers_in_tcp.size(); ++m)
      unknowns.markers_in_tcp[m] = motion_of(body.data()) * start_.markers_in_tcp[m];
  }

  bool is_free(std::size_t mount) const { return problem.column_of_mount(static_cast<int>(mount)) >= 0; }
  std::size_t mount_at(std::size_t observation) const {
    return static_cast<std::size_t>(problem.observations[observation].mount);
  }

  Problem problem;
  Unknowns unknowns;  // its markers are Ceres' own where the body is not held
  bool is_fixed_body;
  MotionNumbers body;
  std::vector<MotionNumbers> mounts;
  Eigen::VectorXd effects;  // in plausible sizes
  MotionManifold mount_manifold{false}, body_manifold{true};
  Eigen::Matrix<double, 6, 12> body_step_by_numbers;
  std::vector<Eigen::Matrix<double, 6, 12>> mount_steps_by_numbers;
  std::vector<Rigid> sensor_from_tcp;
  std::vector<Eigen::Matrix<double, 6, Eigen::Dynamic>> motions;  // motion_by_columns

 private:
  void place_effects(bool derives) {
    if (derives)
      set_effects(problem, unknowns.effects);
    else
      follow_effects(problem, unknowns.effects);
  }
  Unknowns start_;
  bool derives_ = false;
};

/// Measured - predicted of one sighting in units of the noise; its blocks are the marker or the body, the mount where
/// it is estimated, the effects where there are any.
class SightingCost : public ceres::CostFunction {
 public:
  SightingCost(const Place& place, std::size_t observation, std::size_t sighting, double weight)
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

  const Place& place_;
  std::size_t observation_, sighting_;
  double weight_;
};

/// The priors: every effect's number in plausible sizes.
class PriorCost : public ceres::CostFunction {
 public:
  explicit PriorCost(int count) {
    set_num_residuals(count);
    mutable_parameter_block_sizes()->push_back(count);
  }
  bool Evaluate(double const* const* numbers, double* residuals, double** jacobians) const override {
    std::copy(numbers[0], numbers[0] + num_residuals(), residuals);
    if (jacobians && jacobians[0]) Rows(jacobians[0], num_residuals(), num_residuals()).setIdentity();
    return true;
  }
};

/// What images of a board say of the cameras: the square root of their chi-squared's information about its minimum.
class CameraImagesCost : public ceres::CostFunction {
 public:
  explicit CameraImagesCost(const Place& place) : place_(place) {
    const CameraKnowledge& known = *place.problem.camera_images;
    const Eigen::VectorXd scale = known.information.diagonal().cwiseSqrt();
    const Eigen::VectorXd unscale = scale.unaryExpr([](double s) { return s > 0 ? 1 / s : 0.0; });
    const Eigen::MatrixXd scaled = unscale.asDiagonal() * known.information * unscale.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scaled);
    const Eigen::VectorXd roots = solver.eigenvalues().cwiseMax(0.0).cwiseSqrt();
    root_ = roots.asDiagonal() * solver.eigenvectors().transpose() * scale.asDiagonal();
    const Eigen::VectorXd inverse = roots.unaryExpr([](double r) { return r > 1e-9 ? 1 / r : 0.0; });
    shift_ = inverse.asDiagonal() * solver.eigenvectors().transpose() * unscale.asDiagonal() * known.pull;
    set_num_residuals(static_cast<int>(root_.rows()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(place.effects.size()));
  }
  bool Evaluate(double const* const*, double* residuals, double** jacobians) const override {
    const Problem& p = place_.problem;
    Eigen::Map<Eigen::VectorXd>(residuals, root_.rows()) = root_ * change_of_rig(p.camera_images->rig, *p.rig) + shift_;
    if (!jacobians || !jacobians[0]) return true;
    Rows rows(jacobians[0], num_residuals(), p.effect_count());
    rows = root_ * p.cameras_by_effect;
    for (Eigen::Index i = 0; i < p.effect_count(); ++i) rows.col(i) *= place_.sigma(i);
    return true;
  }

 private:
  const Place& place_;
  Eigen::MatrixXd root_;
  Eigen::VectorXd shift_;
};

/// robot_scale_prior.
class RobotScaleCost : public ceres::CostFunction {
 public:
  explicit RobotScaleCost(const Place& place) : place_(place) {
    set_num_residuals(1);
    mutable_parameter_block_sizes()->push_back(static_cast<int>(place.effects.size()));
  }
  bool Evaluate(double const* const*, double* residuals, double** jacobians) const override {
    const RobotScale& scale = *place_.problem.robot_scale;
    residuals[0] = scale.change / robot_scale_sigma;
    for (Eigen::Index i = 0; jacobians && jacobians[0] && i < scale.by_effect.size(); ++i)
      jacobians[0][i] = scale.by_effect[i] / robot_scale_sigma * place_.sigma(i);
    return true;
  }

 private:
  const Place& place_;
};

/// A known distance of two mounts, by their twelve numbers each.
class DistanceCost : public ceres::CostFunction {
 public:
  explicit DistanceCost(const MountDistance& distance) : distance_(distance) {
    set_num_residuals(1);
    mutable_parameter_block_sizes()->assign(2, 12);
  }
  bool Evaluate(double const* const* mounts, double* residuals, double** jacobians) const override {
    const DistanceRow row = distance_row(distance_, motion_of(mounts[0]).translation, motion_of(mounts[1]).translation);
    residuals[0] = row.off;
    for (int m = 0; jacobians && m < 2; ++m) {
      if (!jacobians[m]) continue;
      Rows by(jacobians[m], 1, 12);
      by.setZero();
      by.rightCols<3>() = (m == 0 ? row.by_of : row.by_from).transpose();
    }
    return true;
  }

 private:
  MountDistance distance_;
};

/// What is known of a mount's place, by its twelve numbers.
class PlaceCost : public ceres::CostFunction {
 public:
  PlaceCost(const MountPlace& place, const MotionManifold& manifold) : place_(place), manifold_(manifold) {
    set_num_residuals(1);
    mutable_parameter_block_sizes()->assign(1, 12);
  }
  bool Evaluate(double const* const* mount, double* residuals, double** jacobians) const override {
    const PlaceRow row = place_row(place_, motion_of(mount[0]));
    residuals[0] = row.off;
    if (jacobians && jacobians[0])
      Rows(jacobians[0], 1, 12) = row.by_motion.transpose() * manifold_.step_by_numbers(mount[0]);
    return true;
  }

 private:
  MountPlace place_;
  const MotionManifold& manifold_;
};

/// What is known of the shape of markers that are not held: their places off the known ones, laid onto them as well as
/// can be, in units of the sigma.
class ShapeCost : public ceres::CostFunction {
 public:
  explicit ShapeCost(const Place& place) : place_(place) {
    set_num_residuals(3 * place.problem.marker_count);
    for (int m = 0; m < place.problem.marker_count; ++m) mutable_parameter_block_sizes()->push_back(3);
  }
  bool Evaluate(double const* const*, double* residuals, double** jacobians) const override {
    const PriorRows rows = shape_prior_rows(place_.problem, place_.unknowns.markers_in_tcp);
    const double scale = 1 / place_.problem.noise;  // residuals are in units of the noise
    Eigen::Map<Eigen::VectorXd>(residuals, rows.off.size()) = scale * rows.off;
    for (int m = 0; jacobians && m < place_.problem.marker_count; ++m)
      if (jacobians[m]) Rows(jacobians[m], num_residuals(), 3) = scale * rows.by_markers.middleCols<3>(3 * m);
    return true;
  }

 private:
  const Place& place_;
};

/// Told of every step; ends the search where that wants it, or where a step has gained too little.
class Watch : public ceres::IterationCallback {
 public:
  Watch(const SolveOptions& options, Place& place, double unit) : options_(options), place_(place), unit_(unit) {}
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
  Place& place_;
  double unit_;
};

ceres::LossFunction* loss_function(Loss loss, double limit) {
  if (loss == Loss::huber) return new ceres::HuberLoss(limit);
  return loss == Loss::cauchy ? new ceres::CauchyLoss(limit) : nullptr;
}

void add_sightings(Place& place, const SolveOptions& options, double unit, ceres::Problem& squares) {
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
        losses[rows] = loss_function(options.loss, bend(rows) * options.noise / unit);
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
  Place place(problem, from, options);
  ceres::Problem::Options ownership;
  ownership.evaluation_callback = &place;
  ownership.manifold_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem squares(ownership);
  add_sightings(place, options, unit, squares);
  for (const MountDistance& d : problem.mount_distances)
    squares.AddResidualBlock(new DistanceCost(d), nullptr, place.mounts[static_cast<std::size_t>(d.of)].data(),
                             place.mounts[static_cast<std::size_t>(d.from)].data());
  for (const MountPlace& p : problem.mount_places)
    squares.AddResidualBlock(new PlaceCost(p, place.mount_manifold), nullptr,
                             place.mounts[static_cast<std::size_t>(p.mount)].data());
  for (std::size_t i = 0; i < place.mounts.size(); ++i)
    if (!place.is_free(i) && squares.HasParameterBlock(place.mounts[i].data()))
      squares.SetParameterBlockConstant(place.mounts[i].data());
  for (MotionNumbers& mount : place.mounts)
    if (squares.HasParameterBlock(mount.data())) squares.SetManifold(mount.data(), &place.mount_manifold);
  if (place.is_fixed_body && squares.HasParameterBlock(place.body.data()))
    squares.SetManifold(place.body.data(), &place.body_manifold);
  if (place.effects.size() > 0)
    squares.AddResidualBlock(new PriorCost(static_cast<int>(place.effects.size())), nullptr, place.effects.data());
  if (learns_from_camera_images(problem))
    squares.AddResidualBlock(new CameraImagesCost(place), nullptr, place.effects.data());
  if (holds_robot_scale(problem)) squares.AddResidualBlock(new RobotScaleCost(place), nullptr, place.effects.data());
  if (problem.has_shape_prior() && !place.is_fixed_body) {
    std::vector<double*> markers;
    for (Vector3& x : place.unknowns.markers_in_tcp) markers.push_back(x.data());
    squares.AddResidualBlock(new ShapeCost(place), nullptr, markers);
  }
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
