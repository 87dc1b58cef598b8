// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "camera_calibration/bundle.h"
#include "targets/homography.h"

namespace handsight {
namespace {

constexpr std::size_t least_points = 6;  // of an image: fewer leave a pose to chance

using ImageList = std::vector<const BoardImage*>;

ImageList images_of_frame(const BoardImages& images, int frame) {
  ImageList list;
  for (const BoardImage& image : images.images)
    if (image.frame == frame && image.points.size() >= 4) list.push_back(&image);
  std::stable_sort(list.begin(), list.end(), [](auto* a, auto* b) { return a->points.size() > b->points.size(); });
  return list;
}

/// The pose of a plane from its homography to normalised coordinates.
std::optional<Rigid> pose_from(const Matrix3& homography) {
  const double scale = 2 / (homography.col(0).norm() + homography.col(1).norm());
  Matrix3 h = homography * scale;
  if (h(2, 2) < 0) h = -h;
  Matrix3 axes;
  axes << h.col(0), h.col(1), h.col(0).cross(h.col(1));
  if (!axes.allFinite() || !(std::abs(axes.determinant()) > 1e-9)) return std::nullopt;
  return Rigid{nearest_rotation(axes), h.col(2)};
}

std::optional<Rigid> linear_pose(const BoardImages& images, const Lens& lens, const BoardImage& image) {
  std::vector<PlacePixel> pairs;
  for (const TargetPixel& seen : image.points) {
    const auto ray = lift(lens, seen.pixel);
    if (ray && ray->z() > 0.1)
      pairs.push_back({images.points[static_cast<std::size_t>(seen.number)].head<2>(), ray->hnormalized()});
  }
  const auto homography = linear_homography(pairs);
  return homography ? pose_from(*homography) : std::nullopt;
}

/// The other pose from which a plane looks nearly the same: its normal mirrored in the line of sight.
Rigid mirrored(const Rigid& pose, const Vector3& centre) {
  const Vector3 sight = (pose * centre).normalized(), normal = pose.rotation.col(2);
  const Vector3 other = 2 * normal.dot(sight) * sight - normal;
  const Eigen::Quaterniond turn = turn_between(normal, other);
  Rigid result{turn.toRotationMatrix() * pose.rotation, Vector3::Zero()};
  result.translation = pose * centre - result.rotation * centre;
  return result;
}

struct PoseFit {
  Rigid pose;
  double squares = 1e300;
};

struct PoseSums {
  Matrix6 matrix = Matrix6::Zero();
  Vector6 vector = Vector6::Zero();
  double squares = 0;
  bool is_seen = true;
};

PoseSums pose_sums(const BoardImages& images, const CameraRig& rig, const ImageList& list, const Rigid& pose) {
  PoseSums sums;
  LensProjection p;
  for (const BoardImage* image : list) {
    const auto camera = static_cast<std::size_t>(image->camera);
    const Lens& lens = rig.lenses[camera];
    for (const TargetPixel& seen : image->points) {
      const Vector3 in_first = pose * images.points[static_cast<std::size_t>(seen.number)];
      const Vector3 x = rig.from_first[camera] * in_first;
      if (!lens.model->sees(lens.numbers, x)) {
        sums.is_seen = false;
        return sums;
      }
      lens.model->project(lens.numbers, x, p);
      Eigen::Matrix<double, 3, 6> moved;
      moved << Matrix3::Identity(), -cross_matrix<double>(in_first);
      const Eigen::Matrix<double, 2, 6> row = p.by_point * rig.from_first[camera].rotation * moved;
      const Vector2 residual = p.pixel - seen.pixel;
      sums.matrix += row.transpose() * row;
      sums.vector -= row.transpose() * residual;
      sums.squares += residual.squaredNorm();
    }
  }
  return sums;
}

PoseFit refined_pose(const BoardImages& images, const CameraRig& rig, const ImageList& list, Rigid pose) {
  PoseSums sums = pose_sums(images, rig, list, pose);
  if (!sums.is_seen) return {pose};
  double damping = 1e-6;
  for (int iteration = 0; iteration < 40 && damping < 1e6; ++iteration) {
    Matrix6 damped = sums.matrix;
    damped.diagonal() *= 1 + damping;
    const Vector6 step = damped.ldlt().solve(sums.vector);
    const Rigid next = small_motion<double>(step) * pose;
    const PoseSums then = pose_sums(images, rig, list, next);
    if (!then.is_seen || !(then.squares < sums.squares)) {
      damping *= 10;
      continue;
    }
    const bool is_settled = sums.squares - then.squares < 1e-12 * sums.squares;
    pose = next, sums = then, damping = std::max(damping / 10, 1e-12);
    if (is_settled) break;
  }
  return {pose, sums.squares};
}

// ---- one camera

double focal_from_homographies(const BoardImages& images, int camera, const Vector2& centre) {
  double squares = 0, products = 0;
  for (const BoardImage& image : images.images) {
    if (image.camera != camera || image.points.size() < least_points) continue;
    std::vector<PlacePixel> pairs;
    for (const TargetPixel& seen : image.points)
      pairs.push_back({images.points[static_cast<std::size_t>(seen.number)].head<2>(), (seen.pixel - centre) / 1000});
    const auto h = linear_homography(pairs);
    if (!h) continue;
    const Vector3 a = h->col(0), b = h->col(1);
    const double scale = 1 / (a.squaredNorm() + b.squaredNorm());
    for (const auto& [w, c] :
         {std::pair{a.head<2>().dot(b.head<2>()), a.z() * b.z()},
          {a.head<2>().squaredNorm() - b.head<2>().squaredNorm(), a.z() * a.z() - b.z() * b.z()}}) {
      squares += scale * scale * w * w;
      products += scale * scale * w * c;
    }
  }
  const double inverse_square = squares > 0 ? -products / squares : 0;  // of the focal length in 1000 px
  return inverse_square > 0 ? 1000 / std::sqrt(inverse_square) : 0;
}

BoardImages of_camera(const BoardImages& images, int camera) {
  BoardImages one = images;
  one.camera_count = 1;
  one.images.clear();
  for (BoardImage image : images.images) {
    if (image.camera != camera || image.points.size() < least_points) continue;
    image.camera = 0;
    one.images.push_back(image);
  }
  return one;
}

std::vector<std::optional<Rigid>> poses_with(const BoardImages& images, const CameraRig& rig) {
  std::vector<std::optional<Rigid>> poses(static_cast<std::size_t>(images.frame_count));
  for (int frame = 0; frame < images.frame_count; ++frame)
    poses[static_cast<std::size_t>(frame)] = pose_of_frame(images, rig, frame);
  return poses;
}

BundleResult one_camera(const BoardImages& images, const LensModel& model, const std::pair<int, int>& size, int camera,
                        const std::string& name) {
  const BoardImages one = of_camera(images, camera);
  if (one.images.size() < 3)
    throw InputError(
        message("The target was found with at least {} points in {} of the images of camera {}; expected "
                "at least 3, better 10 and more, from different sides.",
                least_points, one.images.size(), name));
  const Vector2 centre(0.5 * (size.first - 1), 0.5 * (size.second - 1));
  BundleResult best;
  best.rms_pixel = 1e300;
  const double width = std::max(size.first, size.second);
  for (const double focal :
       {focal_from_homographies(images, camera, centre), 0.5 * width, 0.9 * width, 1.6 * width, 3 * width}) {
    if (!(focal > 0.1 * width && focal < 50 * width)) continue;
    CameraRig rig{{{&model, size.first, size.second, std::vector<double>(model.numbers.size(), 0)}}, {Rigid{}}};
    auto& numbers = rig.lenses[0].numbers;
    numbers[0] = numbers[1] = focal, numbers[2] = centre.x(), numbers[3] = centre.y();
    const BundleResult result = adjust_bundle(one, rig, poses_with(one, rig), {}, false);
    if (result.points > 0 && result.rms_pixel < best.rms_pixel) best = result;
    if (best.rms_pixel < 0.002 * width) break;  // a good start is enough
  }
  if (best.points == 0)
    throw InputError(
        message("No focal length was found with which the images of camera {} fit together; expected images "
                "of one flat target from several sides, and the target as it was described.",
                name));
  return best;
}

// ---- several cameras

double apart(const Rigid& a, const Rigid& b) {
  const Vector6 v = small_motion_between(a, b);
  return v.head<3>().norm() / (1e-3 + a.translation.norm()) + v.tail<3>().norm();
}

/// The one of several estimates that is nearest to all others.
Rigid find_middle(const std::vector<Rigid>& estimates) {
  std::size_t best = 0;
  double least = 1e300;
  for (std::size_t i = 0; i < estimates.size(); ++i) {
    double sum = 0;
    for (const Rigid& other : estimates) sum += std::min(apart(estimates[i], other), 1.0);
    if (sum < least) least = sum, best = i;
  }
  return estimates[best];
}

using Poses = std::vector<std::optional<Rigid>>;

std::vector<Rigid> placements(const std::vector<Poses>& poses, const std::vector<std::string>& names) {
  std::vector<Rigid> from_first(poses.size());
  std::vector<bool> is_placed(poses.size(), false);
  is_placed[0] = true;
  for (std::size_t round = 0; round < poses.size(); ++round)
    for (std::size_t c = 1; c < poses.size(); ++c)
      for (std::size_t other = 0; other < poses.size() && !is_placed[c]; ++other) {
        if (!is_placed[other]) continue;
        std::vector<Rigid> estimates;
        for (std::size_t frame = 0; frame < poses[c].size(); ++frame)
          if (poses[c][frame] && poses[other][frame])
            estimates.push_back(*poses[c][frame] * inverse(*poses[other][frame]));
        if (estimates.empty()) continue;
        from_first[c] = find_middle(estimates) * from_first[other];
        is_placed[c] = true;
      }
  for (std::size_t c = 0; c < poses.size(); ++c)
    if (!is_placed[c])
      throw InputError(
          message("Camera {} saw the target in no image that was taken together with one of the other cameras; "
                  "expected images of the same moment, or a run with the images of {} alone.",
                  names[c], names[c]));
  return from_first;
}

}  // namespace

std::optional<Rigid> pose_of_frame(const BoardImages& images, const CameraRig& rig, int frame) {
  const ImageList list = images_of_frame(images, frame);
  PoseFit best;
  Vector3 centre = Vector3::Zero();
  for (const Vector3& point : images.points) centre += point / static_cast<double>(images.points.size());
  for (const BoardImage* image : list) {
    const auto camera = static_cast<std::size_t>(image->camera);
    const auto start = linear_pose(images, rig.lenses[camera], *image);
    if (!start) continue;
    for (const Rigid& pose : {*start, mirrored(*start, centre)}) {
      const PoseFit fit = refined_pose(images, rig, list, inverse(rig.from_first[camera]) * pose);
      if (fit.squares < best.squares) best = fit;
    }
    if (best.squares < 1e300) break;
  }
  return best.squares < 1e300 ? std::optional<Rigid>(best.pose) : std::nullopt;
}

BundleResult start_bundle(const BoardImages& images, const LensModel& model,
                          const std::vector<std::pair<int, int>>& sizes, const std::vector<std::string>& names) {
  CameraRig rig;
  std::vector<Poses> poses;
  for (int camera = 0; camera < images.camera_count; ++camera) {
    const auto c = static_cast<std::size_t>(camera);
    const BundleResult one = one_camera(images, model, sizes[c], camera, names[c]);
    rig.lenses.push_back(one.rig.lenses[0]);
    poses.push_back(one.first_from_target);
  }
  rig.from_first = placements(poses, names);
  return adjust_bundle(images, rig, poses_with(images, rig), {}, false);
}

}  // namespace handsight
