// SPDX-License-Identifier: Apache-2.0
#include "model/sighting.h"

#include <cmath>

#include "base/error.h"

namespace handsight {
namespace {

/// What residuals of an image point are multiplied by: W with W^T W = usual^2 covariance^-1. Nothing: 1.
std::optional<Eigen::Matrix2d> weighting(const std::optional<PixelSigma>& sigma, double usual) {
  if (!sigma || !(usual > 0)) return std::nullopt;
  // The inverse of the covariance's Cholesky factor, in closed form.
  const double slope = sigma->uv / sigma->u, across = std::sqrt(sigma->v * sigma->v - slope * slope);
  return usual * (Eigen::Matrix2d() << 1 / sigma->u, 0, -slope / (sigma->u * across), 1 / across).finished();
}

void weigh(const Sighting& sighting, SightingResidual& r) {
  Eigen::Index row = 0;
  for (const bool is_left : {true, false}) {
    if (!(is_left ? sighting.left : sighting.right)) continue;
    if (const auto w = weighting(is_left ? sighting.left_sigma : sighting.right_sigma, sighting.usual_sigma)) {
      r.error.segment<2>(row) = (*w * r.error.segment<2>(row)).eval();
      r.by_point.middleRows<2>(row) = (*w * r.by_point.middleRows<2>(row)).eval();
    }
    row += 2;
  }
}

}  // namespace

SightingResidual sighting_residual(const StereoRig* rig, const Sighting& sighting, const Vector3& x_in_sensor) {
  SightingResidual r;
  if (sighting.point) {
    const double weight =
        sighting.point_sigma && sighting.usual_sigma > 0 ? sighting.usual_sigma / *sighting.point_sigma : 1.0;
    r.error.head<3>() = weight * (*sighting.point - x_in_sensor);
    r.by_point.topRows<3>() = weight * Matrix3::Identity();
    r.rows = 3;
    return r;
  }
  check(rig != nullptr, "an image sighting of marker {} without cameras", sighting.marker);
  Matrix23 pixel_by_point;
  if (sighting.left) {
    r.error.head<2>() = *sighting.left - project_anywhere(rig->left, x_in_sensor, pixel_by_point);
    r.by_point.topRows<2>() = pixel_by_point;
    r.rows = 2;
    r.in_front = x_in_sensor.z() > 0;
  }
  if (sighting.right) {
    const Vector3 x_in_right = rig->right_from_left * x_in_sensor;
    r.error.segment<2>(r.rows) = *sighting.right - project_anywhere(rig->right, x_in_right, pixel_by_point);
    r.by_point.middleRows<2>(r.rows).noalias() = pixel_by_point * rig->right_from_left.rotation;
    r.rows += 2;
    r.in_front = r.in_front && x_in_right.z() > 0;
  }
  if (sighting.usual_sigma > 0) weigh(sighting, r);
  return r;
}

CameraColumns camera_columns(const StereoRig& rig, const Sighting& s, const Vector3& x) {
  CameraColumns columns = CameraColumns::Zero();
  Eigen::Index row = 0;
  if (s.left) {
    columns.block<2, 8>(row, 6) = pixel_by_camera_numbers_anywhere(rig.left, x);
    if (const auto w = weighting(s.left_sigma, s.usual_sigma))
      columns.middleRows<2>(row) = (*w * columns.middleRows<2>(row)).eval();
    row += 2;
  }
  if (!s.right) return columns;
  const Vector3 in_right = rig.right_from_left * x;
  Matrix23 pixel_by_point;
  project_anywhere(rig.right, in_right, pixel_by_point);
  columns.block<2, 3>(row, 0) = pixel_by_point;
  columns.block<2, 3>(row, 3) = -pixel_by_point * cross_matrix(in_right);
  columns.block<2, 8>(row, 14) = pixel_by_camera_numbers_anywhere(rig.right, in_right);
  if (const auto w = weighting(s.right_sigma, s.usual_sigma))
    columns.middleRows<2>(row) = (*w * columns.middleRows<2>(row)).eval();
  return columns;
}

SightingNormal sighting_normal(const StereoRig* rig, const Sighting& sighting, const Vector3& x_in_sensor) {
  const SightingResidual r = sighting_residual(rig, sighting, x_in_sensor);
  SightingNormal n;
  // Rows that were not measured are zero in both factors: a fixed size costs less than a variable one.
  n.information.noalias() = r.by_point.transpose() * r.by_point;
  n.gradient.noalias() = r.by_point.transpose() * r.error;
  n.cost = r.error.squaredNorm();
  n.rows = r.rows;
  n.in_front = r.in_front;
  return n;
}

int row_count(const Sighting& sighting) {
  if (sighting.point) return 3;
  return (sighting.left ? 2 : 0) + (sighting.right ? 2 : 0);
}

}  // namespace handsight
