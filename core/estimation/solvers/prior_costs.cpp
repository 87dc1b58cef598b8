// SPDX-License-Identifier: Apache-2.0
#include "estimation/solvers/prior_costs.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "estimation/problem/robot_scale.h"
#include "estimation/solvers/priors.h"

namespace handsight {
namespace {

/// The priors: every effect's number in prior sigmas.
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
  explicit CameraImagesCost(const TriedPlace& place) : place_(place) {
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
  const TriedPlace& place_;
  Eigen::MatrixXd root_;
  Eigen::VectorXd shift_;
};

/// robot_scale_prior.
class RobotScaleCost : public ceres::CostFunction {
 public:
  explicit RobotScaleCost(const TriedPlace& place) : place_(place) {
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
  const TriedPlace& place_;
};

/// A known distance of two mounts, by their twelve numbers each.
class DistanceCost : public ceres::CostFunction {
 public:
  explicit DistanceCost(const MountDistance& distance) : distance_(distance) {
    set_num_residuals(1);
    mutable_parameter_block_sizes()->assign(2, 12);
  }
  bool Evaluate(double const* const* mounts, double* residuals, double** jacobians) const override {
    const DistanceRow row =
        distance_row(distance_, make_motion(mounts[0]).translation, make_motion(mounts[1]).translation);
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
    const PlaceRow row = place_row(place_, make_motion(mount[0]));
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
  explicit ShapeCost(const TriedPlace& place) : place_(place) {
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
  const TriedPlace& place_;
};

}  // namespace

void add_mount_priors(TriedPlace& place, ceres::Problem& squares) {
  for (const MountDistance& d : place.problem.mount_distances)
    squares.AddResidualBlock(new DistanceCost(d), nullptr, place.mounts[static_cast<std::size_t>(d.of)].data(),
                             place.mounts[static_cast<std::size_t>(d.from)].data());
  for (const MountPlace& p : place.problem.mount_places)
    squares.AddResidualBlock(new PlaceCost(p, place.mount_manifold), nullptr,
                             place.mounts[static_cast<std::size_t>(p.mount)].data());
}

void add_priors(TriedPlace& place, ceres::Problem& squares) {
  const Problem& problem = place.problem;
  if (place.effects.size() > 0)
    squares.AddResidualBlock(new PriorCost(static_cast<int>(place.effects.size())), nullptr, place.effects.data());
  if (learns_from_camera_images(problem))
    squares.AddResidualBlock(new CameraImagesCost(place), nullptr, place.effects.data());
  if (holds_robot_scale(problem)) squares.AddResidualBlock(new RobotScaleCost(place), nullptr, place.effects.data());
  if (!problem.has_shape_prior() || place.is_fixed_body) return;
  std::vector<double*> markers;
  for (Vector3& x : place.unknowns.markers_in_tcp) markers.push_back(x.data());
  squares.AddResidualBlock(new ShapeCost(place), nullptr, markers);
}

}  // namespace handsight
