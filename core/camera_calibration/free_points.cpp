// SPDX-License-Identifier: Apache-2.0
#include "camera_calibration/free_points.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <algorithm>

namespace handsight {
namespace {

int piece_of(const BoardImages& images, std::size_t number) {
  return images.pieces.empty() ? 0 : images.pieces[number];
}

int piece_count(const BoardImages& images) {
  return images.pieces.empty() ? 1 : *std::max_element(images.pieces.begin(), images.pieces.end()) + 1;
}

std::vector<int> times_seen(const BoardImages& images) {
  std::vector<int> seen(images.points.size(), 0);
  for (const BoardImage& image : images.images)
    for (const TargetPixel& point : image.points) ++seen[static_cast<std::size_t>(point.number)];
  return seen;
}

/// The points of a piece that were seen often enough to hold the others by.
std::vector<std::size_t> firm_points(const BoardImages& images, const std::vector<int>& seen, int piece) {
  int most = 0;
  for (std::size_t i = 0; i < seen.size(); ++i)
    if (piece_of(images, i) == piece) most = std::max(most, seen[i]);
  std::vector<std::size_t> firm;
  for (std::size_t i = 0; i < seen.size(); ++i)
    if (piece_of(images, i) == piece && seen[i] > 0 && 2 * seen[i] >= most) firm.push_back(i);
  return firm;
}

template <class Distance>
std::size_t farthest(const std::vector<std::size_t>& points, const Distance& distance) {
  return *std::max_element(points.begin(), points.end(),
                           [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
}

void hold_piece(const BoardImages& images, const std::vector<std::size_t>& firm, double weight,
                std::vector<Vector3>& weights) {
  if (firm.size() < 3) return;
  const auto at = [&](std::size_t i) { return images.points[i]; };
  const std::size_t a = farthest(firm, [&](std::size_t i) { return (at(i) - at(firm.front())).norm(); });
  const std::size_t b = farthest(firm, [&](std::size_t i) { return (at(i) - at(a)).norm(); });
  const Vector3 along = (at(b) - at(a)).normalized();
  const std::size_t c = farthest(firm, [&](std::size_t i) { return along.cross(at(i) - at(a)).norm(); });
  weights[a] = weights[b] = Vector3::Constant(weight);
  weights[c].z() = weight;
}

double find_extent(const std::vector<Vector3>& points) {
  Eigen::AlignedBox3d box;
  for (const Vector3& point : points) box.extend(point);
  return std::max(box.diagonal().norm(), 1e-6);
}

}  // namespace

std::vector<Vector3> place_weights(const BoardImages& images, const BundleOptions& options) {
  constexpr double far = 0.3, hardly = 1e-5;  // of the target's extent
  const double pixel = std::max(options.pixel_sigma, 1e-3);
  if (options.shape == BoardShape::within)
    return std::vector<Vector3>(images.points.size(), Vector3::Constant(pixel / std::max(*images.sigma, 1e-9)));
  const double extent = find_extent(images.points);
  std::vector<Vector3> weights(images.points.size(), Vector3::Constant(pixel / (far * extent)));
  const std::vector<int> seen = times_seen(images);
  for (int piece = 0; piece < piece_count(images); ++piece)
    hold_piece(images, firm_points(images, seen, piece), pixel / (hardly * extent), weights);
  return weights;
}

void lay_on_description(const BoardImages& images, BundleResult& result) {
  const std::vector<int> seen = times_seen(images);
  const int pieces = piece_count(images);
  const bool is_scaled = pieces == 1 && result.shape == BoardShape::free;
  for (int piece = 0; piece < pieces; ++piece) {
    const std::vector<std::size_t> firm = firm_points(images, seen, piece);
    if (firm.size() < 3) continue;
    Eigen::Matrix3Xd from(3, firm.size()), to(3, firm.size());
    for (std::size_t i = 0; i < firm.size(); ++i) {
      from.col(static_cast<Eigen::Index>(i)) = result.target_points[firm[i]];
      to.col(static_cast<Eigen::Index>(i)) = images.points[firm[i]];
    }
    const Eigen::Matrix4d laid = Eigen::umeyama(from, to, is_scaled);
    const double scale = is_scaled ? laid.topLeftCorner<3, 3>().col(0).norm() : 1;
    const Rigid moved{nearest_rotation(Matrix3(laid.topLeftCorner<3, 3>() / scale)), laid.topRightCorner<3, 1>()};
    for (std::size_t i = 0; i < result.target_points.size(); ++i)
      if (piece_of(images, i) == piece) result.target_points[i] = moved * Vector3(scale * result.target_points[i]);
    for (std::size_t frame = 0; frame < result.first_from_target.size(); ++frame) {
      auto& pose = result.first_from_target[frame];
      if (!pose || static_cast<int>(frame) % pieces != piece) continue;
      pose->translation *= scale;
      pose = *pose * inverse(moved);
    }
    if (!is_scaled) continue;
    for (Rigid& placement : result.rig.from_first) placement.translation *= scale;
  }
}

}  // namespace handsight
