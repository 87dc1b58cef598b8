// SPDX-License-Identifier: Apache-2.0
#include "vision/markers/corner_pairs.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace handsight {
namespace {

struct Normalised {
  std::optional<Vector2> point;
  double sigma = 0;  // px, the worse axis
};

std::vector<Normalised> normalised(const Camera& camera, const std::vector<Corner>& corners) {
  std::vector<Normalised> all;
  all.reserve(corners.size());
  for (const Corner& c : corners) all.push_back({undistort(camera, c.position), std::sqrt(c.covariance.trace())});
  return all;
}

double line_angle_between(double a, double b) {
  const double d = std::abs(std::remainder(a - b, std::numbers::pi));
  return d;
}

/// How unlike two corners look. The two views differ by perspective, so edges may turn by some degrees.
double unlikeness(const Corner& a, const Corner& b) {
  const double straight =
      std::max(line_angle_between(a.edges[0], b.edges[0]), line_angle_between(a.edges[1], b.edges[1]));
  const double crossed =
      std::max(line_angle_between(a.edges[0], b.edges[1]), line_angle_between(a.edges[1], b.edges[0]));
  const double turn = std::min(straight, crossed) / (std::numbers::pi / 4);
  const double contrast = std::abs(a.contrast - b.contrast) / std::max({a.contrast, b.contrast, 1.0});
  return std::clamp(0.5 * turn + 0.5 * contrast, 0.0, 1.0);
}

}  // namespace

Eigen::Matrix2d measured_covariance(const Corner& corner, const PairOptions& options) {
  return corner.covariance + options.corner_floor * options.corner_floor * Eigen::Matrix2d::Identity();
}

std::vector<CornerPair> corner_pairs(const StereoRig& rig, const std::vector<Corner>& left,
                                     const std::vector<Corner>& right, const PairOptions& options,
                                     const std::vector<int>& lefts) {
  const std::vector<Normalised> left_points = normalised(rig.left, left);
  const std::vector<Normalised> right_points = normalised(rig.right, right);
  const Matrix3 essential = essential_matrix(rig);
  std::vector<int> chosen = lefts;
  if (chosen.empty()) {
    chosen.resize(left.size());
    std::iota(chosen.begin(), chosen.end(), 0);
  }

  std::vector<CornerPair> pairs;
  for (const int l : chosen) {
    const Normalised& a = left_points[static_cast<std::size_t>(l)];
    if (!a.point) continue;
    const std::size_t first = pairs.size();
    for (std::size_t r = 0; r < right.size(); ++r) {
      const Normalised& b = right_points[r];
      if (!b.point) continue;
      const double limit = options.epipolar_threshold + 3 * std::hypot(a.sigma, b.sigma);
      if (epipolar_distance(rig, essential, *a.point, *b.point) > limit) continue;
      const Corner& left_corner = left[static_cast<std::size_t>(l)];
      const auto point = triangulate(rig, left_corner.position, right[r].position,
                                     measured_covariance(left_corner, options), measured_covariance(right[r], options));
      if (!point || point->point.z() < options.nearest || point->point.z() > options.farthest) continue;
      pairs.push_back({l, static_cast<int>(r), *point, unlikeness(left_corner, right[r])});
    }
    std::stable_sort(
        pairs.begin() + static_cast<std::ptrdiff_t>(first), pairs.end(),
        [](const CornerPair& p, const CornerPair& q) { return p.point.epipolar_distance < q.point.epipolar_distance; });
  }
  return pairs;
}

}  // namespace handsight
