// SPDX-License-Identifier: Apache-2.0
#include "estimation/problem/running_shape.h"

#include <cmath>

#include "chain/sighting.h"

namespace handsight {
namespace {

struct Point {
  int marker;
  Vector3 in_sensor;
  Matrix3 covariance;
};

std::vector<Point> list_points(const Rig* rig, const std::vector<Sighting>& sightings, double noise) {
  std::vector<Point> points;
  for (const Sighting& s : sightings) {
    if (s.point) {
      points.push_back({s.marker, *s.point, noise * noise * Matrix3::Identity()});
    } else if (rig) {
      if (const auto p = triangulate_unweighed(*rig, s))
        points.push_back({s.marker, p->point, noise * noise * p->covariance});
    }
  }
  return points;
}

}  // namespace

RunningShape::RunningShape(int marker_count) : sums_(static_cast<std::size_t>(marker_count)) {}

std::vector<std::optional<Vector3>> RunningShape::markers() const {
  std::vector<std::optional<Vector3>> all;
  for (const Sum& s : sums_)
    all.push_back(s.information.isZero() ? std::nullopt : std::optional(Vector3(s.information.inverse() * s.right)));
  return all;
}

std::vector<double> RunningShape::sigmas() const {
  std::vector<double> all;
  for (const Sum& s : sums_)
    all.push_back(s.information.isZero() ? 0.0 : std::sqrt(s.information.inverse().trace() / 3));
  return all;
}

void RunningShape::add(const Rig* rig, const std::vector<Sighting>& sightings, double noise) {
  const std::vector<Point> points = list_points(rig, sightings, noise);
  Rigid body_from_sensor;
  if (started_) {
    const auto known = markers();
    Eigen::Matrix3Xd in_body(3, 0), in_sensor(3, 0);
    Eigen::VectorXd weights(0);
    for (const Point& p : points) {
      const auto& marker = known[static_cast<std::size_t>(p.marker)];
      if (!marker) continue;
      in_body.conservativeResize(3, in_body.cols() + 1);
      in_sensor.conservativeResize(3, in_sensor.cols() + 1);
      weights.conservativeResize(weights.size() + 1);
      in_body.rightCols<1>() = *marker;
      in_sensor.rightCols<1>() = p.in_sensor;
      weights[weights.size() - 1] = 1 / p.covariance.trace();
    }
    if (weights.size() < 3) return;
    body_from_sensor = align_points(in_body, in_sensor, weights);
  }
  started_ = started_ || points.size() >= 3;
  if (!started_) return;
  for (const Point& p : points) {
    Sum& sum = sums_[static_cast<std::size_t>(p.marker)];
    const Matrix3 information =
        body_from_sensor.rotation * p.covariance.inverse() * body_from_sensor.rotation.transpose();
    sum.information += information;
    sum.right += information * (body_from_sensor * p.in_sensor);
  }
}

}  // namespace handsight
