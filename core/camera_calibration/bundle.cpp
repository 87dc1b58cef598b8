// SPDX-License-Identifier: Apache-2.0
#include "camera_calibration/bundle.h"

#include <ceres/ceres.h>
#include <glog/logging.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <memory>
#include <set>

namespace handsight {
namespace {

/// A motion as Ceres sees it: translation, rotation vector.
using Six = std::array<double, 6>;

Six six_of(const Rigid& motion) {
  const Vector3 w = vector_from_rotation(motion.rotation);
  return {motion.translation.x(), motion.translation.y(), motion.translation.z(), w.x(), w.y(), w.z()};
}

Rigid rigid_of(const double* six) { return small_motion<double>(Vector6(Eigen::Map<const Vector6>(six))); }

/// d (motion x) / d six: the motion's own numbers, 3 x 6.
Eigen::Matrix<double, 3, 6> moved_by(const double* six, const Vector3& turned_point) {
  Eigen::Matrix<double, 3, 6> m;
  m.leftCols<3>().setIdentity();
  m.rightCols<3>() = -cross_matrix<double>(turned_point) * left_jacobian(Vector3(six[3], six[4], six[5]));
  return m;
}

/// All points of one image: residuals in px by the lens's numbers, the target's pose and the camera's placement.
class ImageCost : public ceres::CostFunction {
 public:
  ImageCost(const BoardImages& images, const BoardImage& image, const LensModel& model)
      : images_(images), image_(image), model_(model) {
    set_num_residuals(2 * static_cast<int>(image.points.size()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(model.numbers.size()));
    mutable_parameter_block_sizes()->push_back(6);
    if (image.camera > 0) mutable_parameter_block_sizes()->push_back(6);
  }

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    const bool is_first = image_.camera == 0;
    const auto count = model_.numbers.size();
    const std::span<const double> numbers(parameters[0], count);
    const Rigid pose = rigid_of(parameters[1]), placement = is_first ? Rigid{} : rigid_of(parameters[2]);
    LensProjection p;
    for (std::size_t i = 0; i < image_.points.size(); ++i) {
      const Vector3 turned = pose.rotation * images_.points[static_cast<std::size_t>(image_.points[i].number)];
      const Vector3 in_first = turned + pose.translation;
      const Vector3 turned_again = placement.rotation * in_first;
      const Vector3 in_camera = turned_again + placement.translation;
      if (!model_.sees(numbers, in_camera)) return false;
      model_.project(numbers, in_camera, p);
      const auto row = static_cast<Eigen::Index>(2 * i);
      Eigen::Map<Vector2>(residuals + row) = p.pixel - image_.points[i].pixel;
      if (!jacobians) continue;
      using Block = Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;
      const Eigen::Index rows = num_residuals();
      if (jacobians[0]) Block(jacobians[0], rows, static_cast<Eigen::Index>(count)).middleRows<2>(row) = p.by_numbers;
      if (jacobians[1])
        Block(jacobians[1], rows, 6).middleRows<2>(row) =
            p.by_point * placement.rotation * moved_by(parameters[1], turned);
      if (!is_first && jacobians[2])
        Block(jacobians[2], rows, 6).middleRows<2>(row) = p.by_point * moved_by(parameters[2], turned_again);
    }
    return true;
  }

 private:
  const BoardImages& images_;
  const BoardImage& image_;
  const LensModel& model_;
};

/// Ceres's losses act on whole blocks; here each point has its own weight, settled between solutions.
class WeightedCost : public ceres::CostFunction {
 public:
  WeightedCost(std::unique_ptr<ImageCost> cost, std::vector<double> weights)
      : cost_(std::move(cost)), weights_(std::move(weights)) {
    set_num_residuals(cost_->num_residuals());
    *mutable_parameter_block_sizes() = cost_->parameter_block_sizes();
  }
  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    if (!cost_->Evaluate(parameters, residuals, jacobians)) return false;
    for (std::size_t i = 0; i < weights_.size(); ++i) {
      residuals[2 * i] *= weights_[i], residuals[2 * i + 1] *= weights_[i];
      for (std::size_t block = 0; jacobians && block < parameter_block_sizes().size(); ++block) {
        const auto columns = static_cast<std::size_t>(parameter_block_sizes()[block]);
        if (!jacobians[block]) continue;
        for (std::size_t k = 0; k < 2 * columns; ++k) jacobians[block][2 * i * columns + k] *= weights_[i];
      }
    }
    return true;
  }

 private:
  std::unique_ptr<ImageCost> cost_;
  std::vector<double> weights_;
};

struct Unknowns {
  std::vector<std::vector<double>> lenses;
  std::vector<Six> placements, poses;
};

std::vector<double> weights_of(const BoardImages& images, const BoardImage& image, const CameraRig& rig,
                               const std::optional<Rigid>& pose, double loss) {
  std::vector<double> weights(image.points.size(), 1);
  if (loss <= 0 || !pose) return weights;
  const auto camera = static_cast<std::size_t>(image.camera);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const TargetPixel& seen = image.points[i];
    const Vector3 x = rig.from_first[camera] * (*pose * images.points[static_cast<std::size_t>(seen.number)]);
    const double error = (project(rig.lenses[camera], x) - seen.pixel).norm();
    if (error > loss) weights[i] = std::sqrt(loss / error);  // Huber
  }
  return weights;
}

struct Problem {
  Unknowns unknowns;
  ceres::Problem solver;
  std::set<int> frames;
};

void build(Problem& problem, const BoardImages& images, const CameraRig& rig,
           const std::vector<std::optional<Rigid>>& poses, double loss) {
  Unknowns& u = problem.unknowns;
  for (const Lens& lens : rig.lenses) u.lenses.push_back(lens.numbers);
  for (const Rigid& motion : rig.from_first) u.placements.push_back(six_of(motion));
  for (const auto& pose : poses) u.poses.push_back(six_of(pose.value_or(Rigid{})));
  for (const BoardImage& image : images.images) {
    const auto camera = static_cast<std::size_t>(image.camera), frame = static_cast<std::size_t>(image.frame);
    if (!poses[frame] || image.points.empty()) continue;
    auto cost = std::make_unique<WeightedCost>(std::make_unique<ImageCost>(images, image, *rig.lenses[camera].model),
                                               weights_of(images, image, rig, poses[frame], loss));
    std::vector<double*> blocks{u.lenses[camera].data(), u.poses[frame].data()};
    if (camera > 0) blocks.push_back(u.placements[camera].data());
    problem.solver.AddResidualBlock(cost.release(), nullptr, blocks);
    problem.frames.insert(image.frame);
  }
}

void take(const Problem& problem, CameraRig& rig, std::vector<std::optional<Rigid>>& poses) {
  for (std::size_t c = 0; c < rig.lenses.size(); ++c) {
    rig.lenses[c].numbers = problem.unknowns.lenses[c];
    if (c > 0) rig.from_first[c] = rigid_of(problem.unknowns.placements[c].data());
  }
  for (const int frame : problem.frames)
    poses[static_cast<std::size_t>(frame)] = rigid_of(problem.unknowns.poses[static_cast<std::size_t>(frame)].data());
}

void set_rms(BundleResult& result, const BoardImages& images) {
  double squares = 0;
  const auto residuals = bundle_residuals(images, result.rig, result.first_from_target);
  for (const BundleResidual& r : residuals) squares += r.residual.squaredNorm();
  result.points = static_cast<int>(residuals.size());
  result.rms_pixel = residuals.empty() ? 0 : std::sqrt(squares / static_cast<double>(residuals.size()));
}

/// The normal equations of lenses, placements and poses, in this order; `cameras`: the first unknowns, of cameras.
struct Information {
  Eigen::MatrixXd matrix;
  std::vector<double*> blocks;
  std::vector<int> starts;  // of each block
  int cameras = 0;
};

Information information_of(Problem& problem, std::size_t camera_count) {
  Information info;
  int size = 0;
  const auto add = [&](double* block) {
    if (!problem.solver.HasParameterBlock(block)) return;
    info.blocks.push_back(block);
    info.starts.push_back(size);
    size += problem.solver.ParameterBlockSize(block);
  };
  for (std::size_t c = 0; c < camera_count; ++c) add(problem.unknowns.lenses[c].data());
  for (std::size_t c = 1; c < camera_count; ++c) add(problem.unknowns.placements[c].data());
  info.cameras = size;
  for (const int frame : problem.frames) add(problem.unknowns.poses[static_cast<std::size_t>(frame)].data());
  ceres::Problem::EvaluateOptions options;
  options.parameter_blocks = info.blocks;
  ceres::CRSMatrix jacobian;
  problem.solver.Evaluate(options, nullptr, nullptr, nullptr, &jacobian);
  info.matrix.setZero(size, size);
  for (int row = 0; row < jacobian.num_rows; ++row) {
    const auto first = static_cast<std::size_t>(jacobian.rows[static_cast<std::size_t>(row)]),
               end = static_cast<std::size_t>(jacobian.rows[static_cast<std::size_t>(row) + 1]);
    for (std::size_t i = first; i < end; ++i)
      for (std::size_t k = first; k < end; ++k)
        info.matrix(jacobian.cols[i], jacobian.cols[k]) += jacobian.values[i] * jacobian.values[k];
  }
  return info;
}

/// Inverse of what the poses leave of the cameras' information (Schur's complement); nothing where that is singular.
std::optional<Eigen::MatrixXd> camera_covariance(const Information& info) {
  const Eigen::Index cameras = info.cameras, size = info.matrix.rows();
  Eigen::MatrixXd left = info.matrix.topLeftCorner(cameras, cameras);
  for (Eigen::Index at = cameras; at + 6 <= size; at += 6) {
    const Eigen::MatrixXd across = info.matrix.block(0, at, cameras, 6);
    const Matrix6 pose = info.matrix.block<6, 6>(at, at);
    left -= across * pose.ldlt().solve(across.transpose());
  }
  // Each number in its own unit, as large as the points alone tell it.
  const Eigen::VectorXd scale = info.matrix.diagonal().head(cameras).cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * left * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scaled);
  if (solver.info() != Eigen::Success || !(solver.eigenvalues()(0) > 1e-13)) return std::nullopt;
  const Eigen::MatrixXd inverse =
      solver.eigenvectors() * solver.eigenvalues().cwiseInverse().asDiagonal() * solver.eigenvectors().transpose();
  return Eigen::MatrixXd(scale.asDiagonal() * inverse * scale.asDiagonal());
}

/// From the numbers of a motion to the small motion v in exp(v) motion: the turn of v moves the translation too.
Matrix6 small_motion_by_numbers(const Six& six) {
  Matrix6 m = Matrix6::Identity();
  const Matrix3 turn = left_jacobian(Vector3(six[3], six[4], six[5]));
  m.bottomRightCorner<3, 3>() = turn;
  m.topRightCorner<3, 3>() = cross_matrix<double>(Vector3(six[0], six[1], six[2])) * turn;
  return m;
}

void set_covariances(BundleResult& result, Problem& problem) {
  const std::size_t count = result.rig.lenses.size();
  result.lens_covariances.assign(count, std::nullopt);
  result.placement_covariances.assign(count, std::nullopt);
  const Information info = information_of(problem, count);
  const auto covariance = camera_covariance(info);
  if (!covariance) return;
  const double freedom = std::max(2.0 * result.points - static_cast<double>(info.matrix.rows()), 1.0);
  const double variance = result.rms_pixel * result.rms_pixel * result.points / freedom;
  Eigen::MatrixXd to_small = Eigen::MatrixXd::Identity(info.cameras, info.cameras);
  for (std::size_t block = 0; block < info.blocks.size(); ++block)
    for (std::size_t c = 0; c < count; ++c) {
      const Eigen::Index at = info.starts[block], size = static_cast<Eigen::Index>(result.rig.lenses[c].numbers.size());
      if (info.blocks[block] == problem.unknowns.lenses[c].data())
        result.lens_covariances[c] = variance * covariance->block(at, at, size, size);
      if (info.blocks[block] != problem.unknowns.placements[c].data()) continue;
      const Matrix6 by_numbers = small_motion_by_numbers(problem.unknowns.placements[c]);
      result.placement_covariances[c] =
          Matrix6(variance * by_numbers * covariance->block<6, 6>(at, at) * by_numbers.transpose());
      to_small.block<6, 6>(at, at) = by_numbers;
    }
  std::size_t numbers = 6 * (count - 1);
  for (const Lens& lens : result.rig.lenses) numbers += lens.numbers.size();
  if (static_cast<std::size_t>(info.cameras) == numbers)  // each camera has seen something
    result.covariance = variance * to_small * *covariance * to_small.transpose();
}

}  // namespace

std::vector<BundleResidual> bundle_residuals(const BoardImages& images, const CameraRig& rig,
                                             const std::vector<std::optional<Rigid>>& first_from_target) {
  std::vector<BundleResidual> residuals;
  for (std::size_t i = 0; i < images.images.size(); ++i) {
    const BoardImage& image = images.images[i];
    const auto camera = static_cast<std::size_t>(image.camera);
    const auto& pose = first_from_target[static_cast<std::size_t>(image.frame)];
    if (!pose) continue;
    for (const TargetPixel& seen : image.points) {
      const Vector3 x = rig.from_first[camera] * (*pose * images.points[static_cast<std::size_t>(seen.number)]);
      residuals.push_back({i, seen.number, seen.pixel, project(rig.lenses[camera], x) - seen.pixel});
    }
  }
  return residuals;
}

BundleResult adjust_bundle(const BoardImages& images, const CameraRig& start,
                           const std::vector<std::optional<Rigid>>& first_from_target, const BundleOptions& options,
                           bool with_covariances) {
  BundleResult result;
  result.rig = start;
  result.first_from_target = first_from_target;
  FLAGS_minloglevel = google::GLOG_FATAL;  // core never prints
  ceres::Solver::Options settings;
  settings.linear_solver_type = ceres::DENSE_SCHUR;
  settings.max_num_iterations = options.most_steps;
  settings.function_tolerance = 1e-12;
  settings.parameter_tolerance = 1e-12;
  settings.logging_type = ceres::SILENT;
  const int rounds = options.loss_pixel > 0 ? 3 : 1;  // weights, then a solution, and again
  std::unique_ptr<Problem> problem;
  for (int round = 0; round < rounds; ++round) {
    problem = std::make_unique<Problem>();
    build(*problem, images, result.rig, result.first_from_target, options.loss_pixel);
    if (problem->solver.NumResidualBlocks() == 0) return result;
    ceres::Solver::Summary summary;
    ceres::Solve(settings, &problem->solver, &summary);
    if (!summary.IsSolutionUsable()) return result;
    result.converged = summary.termination_type == ceres::CONVERGENCE;
    take(*problem, result.rig, result.first_from_target);
  }
  set_rms(result, images);
  if (with_covariances) set_covariances(result, *problem);
  return result;
}

}  // namespace handsight
