// SPDX-License-Identifier: Apache-2.0
#include "simulation/shown_tags.h"

#include <algorithm>
#include <cmath>

namespace handsight {
namespace {

constexpr double same_plane = 0.98;  // of the product of two normals

/// White between two tags of one plane; large where they are of different ones.
double gap_between(const TagPlace& a, const TagPlace& b) {
  const Vector3 off = target_from_tag(a).rotation.transpose() * (b.xyz - a.xyz);
  if (std::abs(off.z()) > a.size) return 1e9;
  return std::max(off.head<2>().cwiseAbs().maxCoeff() - 0.5 * (a.size + b.size), 0.0);
}

/// How far the nearest corner of a tag is from the plane of another.
double distance_to_plane(const TagPlace& a, const TagPlace& b) {
  const Rigid b_from_a = inverse(target_from_tag(b)) * target_from_tag(a);
  double least = 1e9;
  for (const double x : {-0.5, 0.5})
    for (const double y : {-0.5, 0.5})
      least = std::min(least, std::abs((b_from_a * Vector3(x * a.size, y * a.size, 0)).z()));
  return least;
}

}  // namespace

Vector3 mean_point(const std::vector<Vector3>& points) {
  Vector3 middle = Vector3::Zero();
  for (const Vector3& x : points) middle += x / static_cast<double>(points.size());
  return middle;
}

std::vector<Vector3> face_normals(const Target& target) {
  std::vector<Vector3> normals;
  for (const TagPlace& place : target.places) normals.insert(normals.end(), 4, -target_from_tag(place).rotation.col(2));
  const bool differ = std::any_of(normals.begin(), normals.end(),
                                  [&](const Vector3& n) { return n.dot(normals.front()) < same_plane; });
  return differ ? normals : std::vector<Vector3>{};
}

std::vector<Vector3> really_placed(const KnownShape& shape, Random& random) {
  std::vector<Vector3> markers = shape.markers;
  for (const ShapePart& part : shape.parts) {
    const auto from = markers.begin() + part.first;
    const Vector3 middle = mean_point({from, from + part.count});
    const Vector3 shift = part.sigma * random.gaussian3();
    const Matrix3 turn = rotation_from_vector<double>(part.sigma_angle * random.gaussian3());
    std::for_each(from, from + part.count, [&](Vector3& x) { x = middle + shift + turn * Vector3(x - middle); });
  }
  return markers;
}

double rim_of_tag(const Target& target, std::size_t tag) {
  constexpr double least = 1e-3;
  const TagPlace& own = target.places[tag];
  const Vector3 normal = target_from_tag(own).rotation.col(2);
  double rim = 0.25 * own.size;
  for (std::size_t k = 0; k < target.places.size(); ++k) {
    if (k == tag) continue;
    const TagPlace& other = target.places[k];
    const bool is_parallel = std::abs(normal.dot(target_from_tag(other).rotation.col(2))) > same_plane;
    rim = std::min(rim, is_parallel ? 0.48 * gap_between(own, other) : 0.9 * distance_to_plane(own, other));
  }
  return std::max(rim, least);
}

}  // namespace handsight
