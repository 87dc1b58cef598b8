// SPDX-License-Identifier: Apache-2.0
#include "camera_calibration/camera_calibration.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "camera_calibration/bundle.h"
#include "camera_calibration/held_out.h"

namespace handsight {
namespace {

/// Brown's solution as the start of the rational model: the further numbers are 0.
BundleResult as_rational(BundleResult result) {
  for (Lens& lens : result.rig.lenses) {
    lens.model = &rational_lens;
    lens.numbers.resize(rational_lens.numbers.size(), 0);
  }
  return result;
}

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

std::vector<Message> warnings_of(const CameraCalibration& c, const std::vector<std::string>& names) {
  std::vector<Message> warnings;
  int frames = 0;
  for (const auto& pose : c.bundle.first_from_target) frames += pose.has_value();
  if (frames < 8)
    warnings.push_back(message("Only {} poses of the target; 10 to 20 from different sides are better.", frames));
  if (widest_turn(c.bundle) < 20 * M_PI / 180)
    warnings.push_back(
        message("The target is turned by at most {:.0f} degrees from pose to pose: focal length and distance can "
                "hardly be told apart; tilt it by 30 degrees and more, to all sides.",
                widest_turn(c.bundle) * 180 / M_PI));
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto& cells = c.cameras[i].cells;
    const auto seen =
        std::count_if(cells.begin(), cells.end(), [](const ResidualCell& cell) { return cell.points > 0; });
    if (2 * seen < static_cast<std::ptrdiff_t>(cells.size()))
      warnings.push_back(
          message("Camera {}: the points lie in {} of {} parts of the image; the distortion elsewhere is guessed. "
                  "Bring the target into the corners too.",
                  names[i], seen, cells.size()));
    const auto& covariance = c.bundle.lens_covariances[i];
    if (!covariance)
      warnings.push_back(message(
          "Camera {}: these poses do not determine all of its numbers; take images from more sides.", names[i]));
    else if (const double sigma = std::sqrt((*covariance)(0, 0)); sigma > 0.01 * c.bundle.rig.lenses[i].numbers[0])
      warnings.push_back(
          message("Camera {}: the focal length is known to {:.1f} px only ({:.1f} %); tilt the target more.", names[i],
                  sigma, 100 * sigma / c.bundle.rig.lenses[i].numbers[0]));
  }
  return warnings;
}

/// A solution with the target as described.
BundleResult solution_with(const LensModel& model, const BoardImages& images,
                           const std::vector<std::pair<int, int>>& sizes, const std::vector<std::string>& names,
                           const std::optional<FittedModel>& brown) {
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

/// Every lens with the target as described, then every shape with the lens that is preferred, then every lens with the
/// shape that is.
class ModelSearch {
 public:
  ModelSearch(const BoardImages& images, const std::vector<std::pair<int, int>>& sizes,
              const std::vector<std::string>& names)
      : images_(images), sizes_(sizes), names_(names), shapes_(list_shapes(images)) {}

  /// Why a lens does not serve; empty: it does.
  Message add_lens(const LensModel& model) {
    try {
      FittedModel candidate;
      candidate.bundle = solution_with(model, images_, sizes_, names_, brown_);
      if (candidate.bundle.points == 0)
        throw InputError("its least squares do not come to an end from the starts that were tried");
      candidate.held_out = held_out(images_, candidate.bundle);
      if (&model == &brown_lens) brown_ = candidate;
      as_described_.push_back(candidate);
      candidates_.push_back(reshaped(images_, candidate, shapes_.front()));
    } catch (const InputError& error) {
      return error.sentence();
    }
    return {};
  }

  /// Null where no lens serves.
  const FittedModel* best() {
    if (candidates_.empty()) return nullptr;
    // The plain lens first: a bent target seen through it looks much like a flat one seen through another lens.
    for (const LensModel* lens : {&candidates_.front().lens(), &preferred(candidates_)->lens()}) add_shapes(*lens);
    const BoardShape shape = preferred(candidates_)->bundle.shape;
    for (const FittedModel& flat : as_described_) add(flat, shape);
    return preferred(candidates_);
  }

  const FittedModel* find(const LensModel& lens, BoardShape shape) const {
    const auto found = std::find_if(candidates_.begin(), candidates_.end(), [&](const FittedModel& c) {
      return &c.lens() == &lens && c.bundle.shape == shape;
    });
    return found == candidates_.end() ? nullptr : &*found;
  }
  const std::vector<BoardShape>& shapes() const { return shapes_; }

 private:
  void add(const FittedModel& flat, BoardShape shape) {
    if (find(flat.lens(), shape)) return;
    FittedModel candidate = reshaped(images_, flat, shape);
    if (candidate.bundle.shape == shape) candidates_.push_back(std::move(candidate));
  }
  void add_shapes(const LensModel& lens) {
    for (const FittedModel& flat : as_described_)
      if (&flat.lens() == &lens)
        for (const BoardShape shape : shapes_) add(flat, shape);
  }

  const BoardImages& images_;
  const std::vector<std::pair<int, int>>& sizes_;
  const std::vector<std::string>& names_;
  std::vector<BoardShape> shapes_;
  std::optional<FittedModel> brown_;
  std::vector<FittedModel> as_described_, candidates_;
};

std::vector<TriedShape> tried_shapes(const ModelSearch& search, const LensModel& lens) {
  std::vector<TriedShape> tried;
  for (const BoardShape shape : search.shapes())
    if (const FittedModel* c = search.find(lens, shape)) {
      const auto& covariance = c->bundle.bend_covariance;
      tried.push_back({shape, c->bundle.rms_pixel, c->held_out.rms_pixel, c->bundle.bend,
                       covariance ? std::optional<Vector3>(covariance->diagonal().cwiseSqrt()) : std::nullopt});
    }
  return tried;
}

}  // namespace

CameraCalibration calibrate_cameras(const BoardImages& images, const std::vector<std::pair<int, int>>& sizes,
                                    const std::vector<std::string>& names, const CalibrationOptions& options) {
  CameraCalibration result;
  ModelSearch search(images, sizes, names);
  std::vector<const LensModel*> lenses;
  for (const LensModel* model : lens_models()) {
    if (options.model != "best" && options.model != model->name) continue;
    lenses.push_back(model);
    result.tried.push_back({std::string(model->name), 0, 0, search.add_lens(*model)});
  }
  const FittedModel* best = search.best();
  if (!best)
    throw InputError(result.tried.empty() ? message("There is no lens model \"{}\".", options.model)
                                          : result.tried.front().failure);
  for (std::size_t i = 0; i < lenses.size(); ++i)
    if (const FittedModel* c = search.find(*lenses[i], best->bundle.shape))
      result.tried[i].rms_pixel = c->bundle.rms_pixel, result.tried[i].held_out_rms_pixel = c->held_out.rms_pixel;
    else if (result.tried[i].failure.empty())
      result.tried[i].failure = "its least squares do not come to an end with the target's shape in them";
  result.bundle = best->bundle;
  result.held_out = best->held_out;
  result.shapes = tried_shapes(search, best->lens());
  result.cameras = reports_of(with_target(images, result.bundle), result.bundle);
  result.warnings = warnings_of(result, names);
  return result;
}

}  // namespace handsight
