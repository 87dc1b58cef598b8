// SPDX-License-Identifier: Apache-2.0
#include "camera_calibration/held_out.h"

#include <algorithm>
#include <cmath>

#include "base/median.h"
#include "camera_calibration/bundle.h"

namespace handsight {
namespace {

constexpr double better = 0.97;  // of the simpler model's held-out error
constexpr int most_folds = 15;

int list_points(const BoardImages& images, int frame) {
  int count = 0;
  for (const BoardImage& image : images.images)
    if (image.frame == frame && image.points.size() >= 4) count += static_cast<int>(image.points.size());
  return count;
}

BoardImages without(const BoardImages& images, const std::vector<bool>& is_left_out) {
  BoardImages rest = images;
  std::erase_if(rest.images, [&](const BoardImage& i) { return is_left_out[static_cast<std::size_t>(i.frame)]; });
  return rest;
}

/// What Student's t of so many degrees of freedom exceeds once in a thousand (Cornish and Fisher's expansion).
double rare_t(int freedom) {
  constexpr double z = 3.0902;
  const double n = freedom;
  return z + (std::pow(z, 3) + z) / (4 * n) + (5 * std::pow(z, 5) + 16 * std::pow(z, 3) + 3 * z) / (96 * n * n);
}

/// Mean over its standard error, less what would be rare.
double beyond_chance(const std::vector<double>& gains) {
  const int count = static_cast<int>(gains.size());
  if (count < 4) return -1;
  double mean = 0, square = 0;
  for (const double gain : gains) mean += gain / count;
  for (const double gain : gains) square += (gain - mean) * (gain - mean) / (count - 1);
  return square > 0 ? mean / std::sqrt(square / count) - rare_t(count - 1) : -1;
}

/// How many numbers of doubt a model asks for: of two that predict alike the one with fewer is believed.
double boldness(const FittedModel& candidate) {
  const LensModel& lens = candidate.lens();
  const double of_lens = &lens == &brown_lens ? 0 : &lens == &fisheye_lens ? 2 : 3;
  const BoardShape shape = candidate.bundle.shape;
  return of_lens + (shape == BoardShape::bent ? 1 : shape == BoardShape::free ? 2.5 : 0);
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
  for (const BundleResidual& r : bundle_residuals(with_target(images, start), start.rig, start.first_from_target))
    lengths.push_back(r.residual.norm());
  const double sigma = median(lengths) / 1.177;  // of one coordinate, where both are normal
  return adjust_bundle(images, start.rig, start.first_from_target,
                       {.loss_pixel = std::max(4 * sigma, 0.02),
                        .shape = start.shape,
                        .pixel_sigma = sigma,
                        .bend = start.bend,
                        .target_points = start.target_points},
                       with_covariances);
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
    const BoardImages shown = with_target(images, rest);
    for (const int frame : used) {
      if (!is_left_out[static_cast<std::size_t>(frame)]) continue;
      const auto rms = frame_rms(shown, rest.rig, frame);
      result.frames[static_cast<std::size_t>(frame)] = rms;
      if (rms) squares += *rms * *rms * list_points(images, frame), count += list_points(images, frame);
    }
  }
  result.rms_pixel = count > 0 ? std::sqrt(squares / count) : 0;
  return result;
}

bool is_beyond_doubt(const FittedModel& simple, const FittedModel& other) {
  if (!(other.held_out.rms_pixel < better * simple.held_out.rms_pixel)) return false;
  // By squares, where a few views near the image's edge tell; by ratios, where a few views are bad with every model.
  std::vector<double> squares, ratios;
  for (std::size_t i = 0; i < simple.held_out.frames.size() && i < other.held_out.frames.size(); ++i) {
    const auto &a = simple.held_out.frames[i], &b = other.held_out.frames[i];
    if (!a || !b || !(*a > 0) || !(*b > 0)) continue;
    squares.push_back(*a * *a - *b * *b);
    ratios.push_back(std::log(*a / *b));
  }
  return std::max(beyond_chance(squares), beyond_chance(ratios)) > 0;
}

const FittedModel* preferred(const std::vector<FittedModel>& candidates) {
  const FittedModel* chosen = nullptr;
  for (const FittedModel& candidate : candidates) {
    const bool is_excelled = std::any_of(candidates.begin(), candidates.end(), [&](const FittedModel& other) {
      return other.is_known() && is_beyond_doubt(candidate, other);
    });
    if (is_excelled || (chosen && (!candidate.is_known() || boldness(candidate) >= boldness(*chosen)))) continue;
    chosen = &candidate;
  }
  return chosen;
}

std::vector<BoardShape> list_shapes(const BoardImages& images) {
  constexpr std::size_t most_points = 1000;  // that are freed unasked
  if (!images.sigma) return {BoardShape::free};
  const bool is_one =
      std::all_of(images.pieces.begin(), images.pieces.end(), [](const int piece) { return piece == 0; });
  std::vector<BoardShape> shapes{*images.sigma > 0 ? BoardShape::within : BoardShape::held};
  if (!is_one) return shapes;
  if (*images.sigma == 0) shapes.push_back(BoardShape::bent);
  if (images.points.size() <= most_points) shapes.push_back(BoardShape::free);
  return shapes;
}

FittedModel reshaped(const BoardImages& images, const FittedModel& from, BoardShape shape) {
  FittedModel candidate = from;
  if (shape == from.bundle.shape) return candidate;
  candidate.bundle.shape = shape;
  candidate.bundle = adjust_robustly(images, adjust_robustly(images, candidate.bundle, false), true);
  if (candidate.bundle.lens_covariances.empty()) return from;
  candidate.held_out = held_out(images, candidate.bundle);
  return candidate;
}

}  // namespace handsight
