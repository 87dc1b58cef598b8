// SPDX-License-Identifier: Apache-2.0
#include "camera_calibration/bundle_covariance.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace handsight {
namespace {

/// The normal equations: of lenses, placements and the bend (`kept`), then of poses; of each point of the target its
/// own and how it goes with all of those.
struct Information {
  Eigen::MatrixXd matrix;
  std::vector<double*> blocks;
  std::vector<int> starts;  // of each block
  int cameras = 0, kept = 0;
  std::vector<int> numbers;  // of the points that have been seen
  std::vector<Matrix3> points;
  std::vector<Eigen::Matrix3Xd> across;
};

void add_rows(const ceres::CRSMatrix& jacobian, Information& info) {
  const int size = static_cast<int>(info.matrix.rows());
  for (int row = 0; row < jacobian.num_rows; ++row) {
    const auto first = static_cast<std::size_t>(jacobian.rows[static_cast<std::size_t>(row)]),
               end = static_cast<std::size_t>(jacobian.rows[static_cast<std::size_t>(row) + 1]);
    for (std::size_t i = first; i < end; ++i)
      for (std::size_t k = first; k < end; ++k) {
        const int a = jacobian.cols[i], b = jacobian.cols[k];
        const double product = jacobian.values[i] * jacobian.values[k];
        if (a < size && b < size)
          info.matrix(a, b) += product;
        else if (a >= size && b >= size)
          info.points[static_cast<std::size_t>(a - size) / 3]((a - size) % 3, (b - size) % 3) += product;
        else if (a >= size)
          info.across[static_cast<std::size_t>(a - size) / 3]((a - size) % 3, b) += product;
      }
  }
}

Information information_of(BundleProblem& problem) {
  Information info;
  int size = 0;
  const auto add = [&](double* block) {
    if (!problem.solver.HasParameterBlock(block)) return false;
    info.blocks.push_back(block);
    info.starts.push_back(size);
    size += problem.solver.ParameterBlockSize(block);
    return true;
  };
  for (auto& lens : problem.lenses) add(lens.data());
  for (std::size_t c = 1; c < problem.placements.size(); ++c) add(problem.placements[c].data());
  info.cameras = size;
  add(problem.bend.data());
  info.kept = size;
  for (const int frame : problem.frames) add(problem.poses[static_cast<std::size_t>(frame)].data());
  const int without_points = size;
  for (std::size_t i = 0; i < problem.points.size(); ++i)
    if (add(problem.points[i].data())) info.numbers.push_back(static_cast<int>(i));
  info.matrix.setZero(without_points, without_points);
  info.points.assign(info.numbers.size(), Matrix3::Zero());
  info.across.assign(info.numbers.size(), Eigen::Matrix3Xd::Zero(3, without_points));
  ceres::Problem::EvaluateOptions options;
  options.parameter_blocks = info.blocks;
  ceres::CRSMatrix jacobian;
  problem.solver.Evaluate(options, nullptr, nullptr, nullptr, &jacobian);
  add_rows(jacobian, info);
  return info;
}

/// Takes the points out; gives back how many numbers of theirs the images have settled.
double without_points(Information& info, const BundleProblem& problem) {
  double settled = 0;
  for (std::size_t i = 0; i < info.points.size(); ++i) {
    const Matrix3 inverse = info.points[i].ldlt().solve(Matrix3::Identity());
    info.matrix.noalias() -= info.across[i].transpose() * (inverse * info.across[i]);
    const Vector3& weight = problem.weights[static_cast<std::size_t>(info.numbers[i])];
    settled += 3 - (inverse * Matrix3(weight.cwiseAbs2().asDiagonal())).trace();
  }
  return settled;
}

/// Inverse of what the poses leave of the kept information (Schur's complement); nothing where that is singular.
std::optional<Eigen::MatrixXd> kept_covariance(const Information& info) {
  const Eigen::Index kept = info.kept, size = info.matrix.rows(), poses = size - kept;
  Eigen::MatrixXd left = info.matrix.topLeftCorner(kept, kept);
  if (info.points.empty()) {
    for (Eigen::Index at = kept; at + 6 <= size; at += 6) {
      const Eigen::MatrixXd across = info.matrix.block(0, at, kept, 6);
      const Matrix6 pose = info.matrix.block<6, 6>(at, at);
      left -= across * pose.ldlt().solve(across.transpose());
    }
  } else {  // the target's points tie the poses together
    const Eigen::MatrixXd across = info.matrix.topRightCorner(kept, poses);
    left -= across * info.matrix.bottomRightCorner(poses, poses).ldlt().solve(across.transpose());
  }
  // Each number in its own unit, as large as the points alone tell it.
  const Eigen::VectorXd scale = info.matrix.diagonal().head(kept).cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
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

}  // namespace

void set_covariances(BundleResult& result, BundleProblem& problem) {
  const std::size_t count = result.rig.lenses.size();
  result.lens_covariances.assign(count, std::nullopt);
  result.placement_covariances.assign(count, std::nullopt);
  Information info = information_of(problem);
  const double settled = static_cast<double>(info.matrix.rows()) + without_points(info, problem);
  const auto covariance = kept_covariance(info);
  if (!covariance) return;
  const double freedom = std::max(2.0 * result.points - settled, 1.0);
  const double variance = result.rms_pixel * result.rms_pixel * result.points / freedom;
  Eigen::MatrixXd to_small = Eigen::MatrixXd::Identity(info.cameras, info.cameras);
  for (std::size_t block = 0; block < info.blocks.size(); ++block) {
    const Eigen::Index at = info.starts[block];
    if (info.blocks[block] == problem.bend.data())
      result.bend_covariance = Matrix3(variance * covariance->block<3, 3>(at, at));
    for (std::size_t c = 0; c < count; ++c) {
      const auto size = static_cast<Eigen::Index>(result.rig.lenses[c].numbers.size());
      if (info.blocks[block] == problem.lenses[c].data())
        result.lens_covariances[c] = variance * covariance->block(at, at, size, size);
      if (info.blocks[block] != problem.placements[c].data()) continue;
      const Matrix6 by_numbers = small_motion_by_numbers(problem.placements[c]);
      result.placement_covariances[c] =
          Matrix6(variance * by_numbers * covariance->block<6, 6>(at, at) * by_numbers.transpose());
      to_small.block<6, 6>(at, at) = by_numbers;
    }
  }
  std::size_t numbers = 6 * (count - 1);
  for (const Lens& lens : result.rig.lenses) numbers += lens.numbers.size();
  if (static_cast<std::size_t>(info.cameras) == numbers)  // each camera has seen something
    result.covariance =
        variance * to_small * covariance->topLeftCorner(info.cameras, info.cameras) * to_small.transpose();
}

}  // namespace handsight
