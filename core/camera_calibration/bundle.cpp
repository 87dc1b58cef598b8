// SPDX-License-Identifier: Apache-2.0
#include "camera_calibration/bundle.h"

#include <ceres/ceres.h>
#include <glog/logging.h>

#include <Eigen/Dense>
#include <cmath>
#include <memory>
#include <set>

#include "camera_calibration/bent_board.h"
#include "camera_calibration/bundle_covariance.h"
#include "camera_calibration/free_points.h"

namespace handsight {
namespace {

bool has_free_points(const BundleOptions& options) {
  return options.shape == BoardShape::within || options.shape == BoardShape::free;
}

std::vector<double> weights_of(const BoardImages& now, const BoardImage& image, const CameraRig& rig, const Rigid& pose,
                               double loss) {
  std::vector<double> weights(image.points.size(), 1);
  if (loss <= 0) return weights;
  const auto camera = static_cast<std::size_t>(image.camera);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const TargetPixel& seen = image.points[i];
    const Vector3 x = rig.from_first[camera] * (pose * now.points[static_cast<std::size_t>(seen.number)]);
    const double error = (project(rig.lenses[camera], x) - seen.pixel).norm();
    if (error > loss) weights[i] = std::sqrt(loss / error);  // Huber
  }
  return weights;
}

/// One cost an image; where every point of the target is estimated one for each point, so that Ceres can take the
/// points out one by one.
void add_image(BundleProblem& problem, const BoardImages& images, const BoardImage& image, const LensModel& model,
               const std::vector<double>& weights, const BundleOptions& options) {
  const auto camera = static_cast<std::size_t>(image.camera);
  std::vector<double*> blocks{problem.lenses[camera].data(),
                              problem.poses[static_cast<std::size_t>(image.frame)].data()};
  if (camera > 0) blocks.push_back(problem.placements[camera].data());
  if (!has_free_points(options)) {
    const bool is_bent = options.shape == BoardShape::bent;
    if (is_bent) blocks.push_back(problem.bend.data());
    problem.solver.AddResidualBlock(
        image_cost(images, image.camera, model, image.points, weights, is_bent ? ShapeBlock::bend : ShapeBlock::none)
            .release(),
        nullptr, blocks);
    return;
  }
  blocks.push_back(nullptr);
  for (std::size_t i = 0; i < image.points.size(); ++i) {
    blocks.back() = problem.points[static_cast<std::size_t>(image.points[i].number)].data();
    problem.solver.AddResidualBlock(
        image_cost(images, image.camera, model, {image.points[i]}, {weights[i]}, ShapeBlock::point).release(), nullptr,
        blocks);
  }
}

void build(BundleProblem& problem, const BoardImages& images, const BundleResult& now, const BundleOptions& options) {
  for (const Lens& lens : now.rig.lenses) problem.lenses.push_back(lens.numbers);
  for (const Rigid& motion : now.rig.from_first) problem.placements.push_back(make_six(motion));
  for (const auto& pose : now.first_from_target) problem.poses.push_back(make_six(pose.value_or(Rigid{})));
  problem.bend = {now.bend.x(), now.bend.y(), now.bend.z()};
  if (has_free_points(options)) {
    for (const Vector3& x : now.target_points) problem.points.push_back({x.x(), x.y(), x.z()});
    problem.weights = place_weights(images, options);
  }
  const BoardImages shown = with_target(images, now);
  std::set<int> frames, numbers;
  for (const BoardImage& image : images.images) {
    const auto& pose = now.first_from_target[static_cast<std::size_t>(image.frame)];
    if (!pose || image.points.empty()) continue;
    add_image(problem, images, image, *now.rig.lenses[static_cast<std::size_t>(image.camera)].model,
              weights_of(shown, image, now.rig, *pose, options.loss_pixel), options);
    frames.insert(image.frame);
    for (const TargetPixel& seen : image.points) numbers.insert(seen.number);
  }
  problem.frames.assign(frames.begin(), frames.end());
  for (const int number : numbers) {
    const auto i = static_cast<std::size_t>(number);
    if (has_free_points(options))
      problem.solver.AddResidualBlock(place_cost(images.points[i], problem.weights[i]).release(), nullptr,
                                      problem.points[i].data());
  }
}

void take(const BundleProblem& problem, const BoardImages& images, const BundleOptions& options, BundleResult& result) {
  for (std::size_t c = 0; c < result.rig.lenses.size(); ++c) {
    result.rig.lenses[c].numbers = problem.lenses[c];
    if (c > 0) result.rig.from_first[c] = make_rigid(problem.placements[c].data());
  }
  for (const int frame : problem.frames)
    result.first_from_target[static_cast<std::size_t>(frame)] =
        make_rigid(problem.poses[static_cast<std::size_t>(frame)].data());
  for (std::size_t i = 0; i < problem.points.size(); ++i)
    result.target_points[i] = Eigen::Map<const Vector3>(problem.points[i].data());
  if (options.shape != BoardShape::bent) return;
  result.bend = Eigen::Map<const Vector3>(problem.bend.data());
  const Vector3 middle = find_middle(images.points);
  for (std::size_t i = 0; i < images.points.size(); ++i)
    result.target_points[i] = bent_point(images.points[i], middle, result.bend);
}

void set_rms(BundleResult& result, const BoardImages& images) {
  double squares = 0;
  const auto residuals = bundle_residuals(with_target(images, result), result.rig, result.first_from_target);
  for (const BundleResidual& r : residuals) squares += r.residual.squaredNorm();
  result.points = static_cast<int>(residuals.size());
  result.rms_pixel = residuals.empty() ? 0 : std::sqrt(squares / static_cast<double>(residuals.size()));
}

ceres::Solver::Options settings_of(const BundleOptions& options, BundleProblem& problem) {
  ceres::Solver::Options settings;
  settings.linear_solver_type = ceres::DENSE_SCHUR;
  settings.max_num_iterations = options.most_steps;
  settings.function_tolerance = 1e-12;
  settings.parameter_tolerance = 1e-12;
  settings.logging_type = ceres::SILENT;
  if (!has_free_points(options)) return settings;
  settings.function_tolerance = 1e-9;  // hundreds of numbers, of which each is known much less well
  settings.linear_solver_ordering = std::make_shared<ceres::ParameterBlockOrdering>();
  std::vector<double*> blocks;
  problem.solver.GetParameterBlocks(&blocks);
  std::set<const double*> points;
  for (const auto& point : problem.points) points.insert(point.data());
  for (double* block : blocks)
    settings.linear_solver_ordering->AddElementToGroup(block, points.contains(block) ? 0 : 1);
  return settings;
}

BundleResult make_start(const BoardImages& images, const CameraRig& rig, const std::vector<std::optional<Rigid>>& poses,
                        const BundleOptions& options) {
  BundleResult start;
  start.rig = rig;
  start.first_from_target = poses;
  start.shape = options.shape;
  start.target_points =
      options.target_points.empty() || !has_free_points(options) ? images.points : options.target_points;
  if (options.shape != BoardShape::bent) return start;
  start.bend = options.bend;
  const Vector3 middle = find_middle(images.points);
  for (Vector3& point : start.target_points) point = bent_point(point, middle, start.bend);
  return start;
}

}  // namespace

BoardImages with_target(const BoardImages& images, const BundleResult& result) {
  BoardImages shown = images;
  if (!result.target_points.empty()) shown.points = result.target_points;
  return shown;
}

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
  BundleResult result = make_start(images, start, first_from_target, options);
  FLAGS_minloglevel = google::GLOG_FATAL;             // core never prints
  const int rounds = options.loss_pixel > 0 ? 3 : 1;  // weights, then a solution, and again
  std::unique_ptr<BundleProblem> problem;
  for (int round = 0; round < rounds; ++round) {
    problem = std::make_unique<BundleProblem>();
    build(*problem, images, result, options);
    if (problem->solver.NumResidualBlocks() == 0) return result;
    ceres::Solver::Summary summary;
    ceres::Solve(settings_of(options, *problem), &problem->solver, &summary);
    if (!summary.IsSolutionUsable()) return result;
    result.converged = summary.termination_type == ceres::CONVERGENCE;
    take(*problem, images, options, result);
  }
  set_rms(result, images);
  if (with_covariances) set_covariances(result, *problem);
  if (has_free_points(options)) lay_on_description(images, result);
  return result;
}

}  // namespace handsight
