// SPDX-License-Identifier: Apache-2.0
#include "camera_calibration/camera_calibration.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace handsight {
namespace {

constexpr double kBetter = 0.97;  // of brown's held-out error: what another model must reach
constexpr int most_folds = 15;

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

BoardImages without(const BoardImages& images, const std::vector<bool>& is_left_out) {
  BoardImages rest = images;
  std::erase_if(rest.images, [&](const BoardImage& i) { return is_left_out[static_cast<std::size_t>(i.frame)]; });
  return rest;
}

int points_of(const BoardImages& images, int frame) {
  int count = 0;
  for (const BoardImage& image : images.images)
    if (image.frame == frame && image.points.size() >= 4) count += static_cast<int>(image.points.size());
  return count;
}

HeldOut held_out(const BoardImages& images, const BundleResult& whole) {
  HeldOut result;
  result.frames.assign(static_cast<std::size_t>(images.frame_count), std::nullopt);
  std::vector<int> used;
  for (int frame = 0; frame < images.frame_count; ++frame)
    if (whole.first_from_target[static_cast<std::size_t>(frame)]) used.push_back(frame);
  const int folds = std::min<int>(static_cast<int>(used.size()), used.size() <= most_folds ? most_folds : 10);
  double squares = 0, count = 0;
  for (int fold = 0; fold < folds && used.size() > 3; ++fold) {
    std::vector<bool> is_left_out(static_cast<std::size_t>(images.frame_count), false);
    for (std::size_t i = static_cast<std::size_t>(fold); i < used.size(); i += static_cast<std::size_t>(folds))
      is_left_out[static_cast<std::size_t>(used[i])] = true;
    const BundleResult rest = adjust_robustly(without(images, is_left_out), whole, false);
    for (const int frame : used) {
      if (!is_left_out[static_cast<std::size_t>(frame)]) continue;
      const auto rms = frame_rms(images, rest.rig, frame);
      result.frames[static_cast<std::size_t>(frame)] = rms;
      if (rms) squares += *rms * *rms * points_of(images, frame), count += points_of(images, frame);
    }
  }
  result.rms_pixel = count > 0 ? std::sqrt(squares / count) : 0;
  return result;
}

/// Brown's solution as the start of the rational model: the further numbers are 0.
BundleResult as_rational(BundleResult result) {
  for (Lens& lens : result.rig.lenses) {
    lens.model = &rational_lens;
    lens.numbers.resize(rational_lens.numbers.size(), 0);
  }
  return result;
}

struct Candidate {
  BundleResult bundle;
  HeldOut held_out;
};

std::vector<CameraReport> reports_of(const BoardImages& images, const BundleResult& bundle) {
  std::vector<CameraReport> reports(static_cast<std::size_t>(images.camera_count));
  for (CameraReport& report : reports) report.cells.resize(CameraReport::columns * CameraReport::rows);
  for (const BoardImage& image : images.images)
    if (bundle.first_from_target[static_cast<std::size_t>(image.frame)] && !image.points.empty())
      ++reports[static_cast<std::size_t>(image.camera)].images;
  for (const BundleResidual& r : bundle_residuals(images, bundle.rig, bundle.first_from_target)) {
    const auto camera = static_cast<std::size_t>(images.images[r.image].camera);
    const Lens& lens = bundle.rig.lenses[camera];
    CameraReport& report = reports[camera];
    const int column = std::clamp(static_cast<int>((r.pixel.x() + 0.5) / lens.width * CameraReport::columns), 0,
                                  CameraReport::columns - 1);
    const int row =
        std::clamp(static_cast<int>((r.pixel.y() + 0.5) / lens.height * CameraReport::rows), 0, CameraReport::rows - 1);
    ResidualCell& cell = report.cells[static_cast<std::size_t>(row * CameraReport::columns + column)];
    ++cell.points, ++report.points;
    cell.mean += r.residual;
    cell.rms_pixel += r.residual.squaredNorm();
    report.rms_pixel += r.residual.squaredNorm();
  }
  for (CameraReport& report : reports) {
    report.rms_pixel = std::sqrt(report.rms_pixel / std::max(report.points, 1));
    for (ResidualCell& cell : report.cells)
      if (cell.points > 0) cell.mean /= cell.points, cell.rms_pixel = std::sqrt(cell.rms_pixel / cell.points);
  }
  return reports;
}

/// rad: the largest angle between two of the target's normals, as the first camera sees them.
double widest_turn(const BundleResult& bundle) {
  double widest = 0;
  for (const auto& a : bundle.first_from_target)
    for (const auto& b : bundle.first_from_target)
      if (a && b)
        widest = std::max(widest, std::acos(std::clamp(a->rotation.col(2).dot(b->rotation.col(2)), -1.0, 1.0)));
  return widest;
}

std::vector<std::string> warnings_of(const CameraCalibration& c, const std::vector<std::string>& names) {
  std::vector<std::string> warnings;
  int frames = 0;
  for (const auto& pose : c.bundle.first_from_target) frames += pose.has_value();
  if (frames < 8)
    warnings.push_back(fmt::format("Only {} poses of the target; 10 to 20 from different sides are better.", frames));
  if (widest_turn(c.bundle) < 20 * M_PI / 180)
    warnings.push_back(
        fmt::format("The target is turned by at most {:.0f} degrees from pose to pose: focal length and distance can "
                    "hardly be told apart; tilt it by 30 degrees and more, to all sides.",
                    widest_turn(c.bundle) * 180 / M_PI));
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto& cells = c.cameras[i].cells;
    const auto seen =
        std::count_if(cells.begin(), cells.end(), [](const ResidualCell& cell) { return cell.points > 0; });
    if (2 * seen < static_cast<std::ptrdiff_t>(cells.size()))
      warnings.push_back(
          fmt::format("Camera {}: the points lie in {} of {} parts of the image; the distortion elsewhere is guessed. "
                      "Bring the target into the corners too.",
                      names[i], seen, cells.size()));
    const auto& covariance = c.bundle.lens_covariances[i];
    if (!covariance)
      warnings.push_back(fmt::format(
          "Camera {}: these poses do not determine all of its numbers; take images from more sides.", names[i]));
    else if (const double sigma = std::sqrt((*covariance)(0, 0)); sigma > 0.01 * c.bundle.rig.lenses[i].numbers[0])
      warnings.push_back(
          fmt::format("Camera {}: the focal length is known to {:.1f} px only ({:.1f} %); tilt the target more.",
                      names[i], sigma, 100 * sigma / c.bundle.rig.lenses[i].numbers[0]));
  }
  return warnings;
}

BundleResult solution_with(const LensModel& model, const BoardImages& images,
                           const std::vector<std::pair<int, int>>& sizes, const std::vector<std::string>& names,
                           const std::optional<Candidate>& brown) {
  BundleResult start = &model == &rational_lens
                           ? as_rational(brown ? brown->bundle : start_bundle(images, brown_lens, sizes, names))
                           : start_bundle(images, model, sizes, names);
  start = adjust_robustly(images, start, false);
  // Frames that had no pose with the first cameras may have one now.
  for (int frame = 0; frame < images.frame_count; ++frame)
    if (auto& pose = start.first_from_target[static_cast<std::size_t>(frame)]; !pose)
      pose = pose_of_frame(images, start.rig, frame);
  return adjust_robustly(images, start, true);
}

}  // namespace

std::optional<double> frame_rms(const BoardImages& images, const CameraRig& rig, int frame) {
  const auto pose = pose_of_frame(images, rig, frame);
  if (!pose) return std::nullopt;
  double squares = 0;
  int count = 0;
  for (const BoardImage& image : images.images) {
    if (image.frame != frame || image.points.size() < 4) continue;
    const auto camera = static_cast<std::size_t>(image.camera);
    for (const TargetPixel& seen : image.points) {
      const Vector3 x = rig.from_first[camera] * (*pose * images.points[static_cast<std::size_t>(seen.number)]);
      squares += (project(rig.lenses[camera], x) - seen.pixel).squaredNorm();
      ++count;
    }
  }
  return count > 0 ? std::optional<double>(std::sqrt(squares / count)) : std::nullopt;
}

BundleResult adjust_robustly(const BoardImages& images, const BundleResult& start, bool with_covariances) {
  std::vector<double> lengths;
  for (const BundleResidual& r : bundle_residuals(images, start.rig, start.first_from_target))
    lengths.push_back(r.residual.norm());
  const double sigma = median(lengths) / 1.177;  // of one coordinate, where both are normal
  return adjust_bundle(images, start.rig, start.first_from_target, {.loss_pixel = std::max(4 * sigma, 0.02)},
                       with_covariances);
}

namespace {

/// What share of the best held-out error a further model must stay below: of two that predict alike the one with fewer
/// numbers is taken, and none in place of the usual lens that is not clearly better.
double least_gain(const LensModel& model, const Candidate& best) {
  const LensModel& so_far = *best.bundle.rig.lenses[0].model;
  const bool is_simpler = &so_far != &brown_lens && model.numbers.size() < so_far.numbers.size();
  return is_simpler ? 1 / kBetter : kBetter;
}

}  // namespace

CameraCalibration calibrate_cameras(const BoardImages& images, const std::vector<std::pair<int, int>>& sizes,
                                    const std::vector<std::string>& names, const CalibrationOptions& options) {
  CameraCalibration result;
  std::optional<Candidate> best, brown;
  for (const LensModel* model : lens_models()) {
    if (options.model != "best" && options.model != model->name) continue;
    TriedModel tried{std::string(model->name), 0, 0, {}};
    try {
      Candidate candidate;
      candidate.bundle = solution_with(*model, images, sizes, names, brown);
      if (candidate.bundle.points == 0)
        throw InputError("its least squares do not come to an end from the starts that were tried");
      candidate.held_out = held_out(images, candidate.bundle);
      tried.rms_pixel = candidate.bundle.rms_pixel, tried.held_out_rms_pixel = candidate.held_out.rms_pixel;
      if (model == &brown_lens) brown = candidate;
      const bool is_known = candidate.held_out.rms_pixel > 0 && candidate.bundle.lens_covariances[0].has_value();
      if (!best || (is_known && candidate.held_out.rms_pixel < least_gain(*model, *best) * best->held_out.rms_pixel))
        best = candidate;
    } catch (const InputError& error) {
      if (model == &brown_lens && options.model == "best" && lens_models().size() == 1) throw;
      tried.failure = error.what();
    }
    result.tried.push_back(std::move(tried));
  }
  if (!best)
    throw InputError(result.tried.empty() ? fmt::format("There is no lens model \"{}\".", options.model)
                                          : result.tried.front().failure);
  result.bundle = best->bundle;
  result.held_out = best->held_out;
  result.cameras = reports_of(images, result.bundle);
  result.warnings = warnings_of(result, names);
  return result;
}

}  // namespace handsight
