// SPDX-License-Identifier: Apache-2.0
#include "chain/sighting.h"

#include <array>
#include <cmath>

#include "base/error.h"
#include "session/fixtures/fixture_kind.h"

namespace handsight {
namespace {

/// What residuals of an image point are multiplied by: W with W^T W = usual^2 covariance^-1. Nothing: 1.
std::optional<Eigen::Matrix2d> weighting(const std::optional<PixelSigma>& sigma, double usual) {
  if (!sigma || !(usual > 0)) return std::nullopt;
  // The inverse of the covariance's Cholesky factor, in closed form.
  const double slope = sigma->uv / sigma->u, across = std::sqrt(sigma->v * sigma->v - slope * slope);
  return usual * (Eigen::Matrix2d() << 1 / sigma->u, 0, -slope / (sigma->u * across), 1 / across).finished();
}

/// What is read off, and by the point.
struct ReadingResidual {
  double error = 0;
  Vector3 by_point;
};

ReadingResidual reading_residual(const Sighting& s, const Vector3& x) {
  return {s.reading->of(*s.point) - s.reading->of(x), s.reading->by_tip(x)};
}

double point_weight(const Sighting& s) {
  return s.point_sigma && s.usual_sigma > 0 ? s.usual_sigma / *s.point_sigma : 1.0;
}

/// What one camera has to say of the point.
struct CameraRows {
  Vector2 error;
  Matrix23 by_point;
  bool in_front = true;
};

CameraRows camera_rows(const Rig& rig, const CameraPoint& seen, double usual_sigma, const Vector3& x_in_sensor) {
  const RigCamera& c = rig.at(seen.camera);
  CameraRows r;
  if (seen.camera == 0) {
    r.error = seen.pixel - project_anywhere(c.camera, x_in_sensor, r.by_point);
    r.in_front = x_in_sensor.z() > 0;
  } else {
    const Vector3 in_camera = c.camera_from_first * x_in_sensor;
    Matrix23 by_camera_point;
    r.error = seen.pixel - project_anywhere(c.camera, in_camera, by_camera_point);
    r.by_point.noalias() = by_camera_point * c.camera_from_first.rotation;
    r.in_front = in_camera.z() > 0;
  }
  if (const auto w = weighting(seen.sigma, usual_sigma)) {
    r.error = (*w * r.error).eval();
    r.by_point = (*w * r.by_point).eval();
  }
  return r;
}

}  // namespace

SightingResidual sighting_residual(const Rig* rig, const Sighting& sighting, const Vector3& x_in_sensor) {
  SightingResidual r;
  r.rows = row_count(sighting);
  r.error.resize(r.rows);
  r.by_point.resize(r.rows, 3);
  if (sighting.reading) {
    const double weight = point_weight(sighting);
    const ReadingResidual reading = reading_residual(sighting, x_in_sensor);
    r.error[0] = weight * reading.error;
    r.by_point = weight * reading.by_point.transpose();
    return r;
  }
  if (sighting.along) {
    const double weight = point_weight(sighting);
    r.error[0] = weight * sighting.along->dot(*sighting.point - x_in_sensor);
    r.by_point = weight * sighting.along->transpose();
    return r;
  }
  if (sighting.point) {
    const double weight = point_weight(sighting);
    r.error = weight * (*sighting.point - x_in_sensor);
    r.by_point = weight * Matrix3::Identity();
    return r;
  }
  check(rig != nullptr, "an image sighting of marker {} without cameras", sighting.marker);
  Eigen::Index row = 0;
  for (const CameraPoint& seen : sighting.in_cameras) {
    const CameraRows rows = camera_rows(*rig, seen, sighting.usual_sigma, x_in_sensor);
    r.error.segment<2>(row) = rows.error;
    r.by_point.middleRows<2>(row) = rows.by_point;
    r.in_front = r.in_front && rows.in_front;
    row += 2;
  }
  return r;
}

CameraColumns camera_columns(const Rig& rig, const Sighting& s, const Vector3& x) {
  CameraColumns columns = CameraColumns::Zero(row_count(s), rig_number_count(rig.count()));
  Eigen::Index row = 0;
  for (const CameraPoint& seen : s.in_cameras) {
    const RigCamera& c = rig.at(seen.camera);
    const Vector3 in_camera = seen.camera == 0 ? x : c.camera_from_first * x;
    Eigen::Matrix<double, 2, camera_number_count> by_numbers = pixel_by_camera_numbers_anywhere(c.camera, in_camera);
    Eigen::Matrix<double, 2, 6> by_motion = Eigen::Matrix<double, 2, 6>::Zero();
    if (seen.camera > 0) {
      Matrix23 pixel_by_point;
      project_anywhere(c.camera, in_camera, pixel_by_point);
      by_motion << pixel_by_point, -pixel_by_point * cross_matrix(in_camera);
    }
    if (const auto w = weighting(seen.sigma, s.usual_sigma)) {
      by_numbers = (*w * by_numbers).eval();
      by_motion = (*w * by_motion).eval();
    }
    columns.block<2, camera_number_count>(row, first_number(rig.count(), seen.camera)) = by_numbers;
    if (seen.camera > 0) columns.block<2, 6>(row, motion_number(seen.camera)) = by_motion;
    row += 2;
  }
  return columns;
}

namespace {

/// The usual case in one product of a fixed size; rows that were not measured are zero in both factors.
SightingNormal normal_of_two(const Rig& rig, const Sighting& sighting, const Vector3& x_in_sensor) {
  Eigen::Matrix<double, 4, 1> error = Eigen::Matrix<double, 4, 1>::Zero();
  Eigen::Matrix<double, 4, 3> by_point = Eigen::Matrix<double, 4, 3>::Zero();
  SightingNormal n;
  for (const CameraPoint& seen : sighting.in_cameras) {
    const CameraRows rows = camera_rows(rig, seen, sighting.usual_sigma, x_in_sensor);
    error.segment<2>(n.rows) = rows.error;
    by_point.middleRows<2>(n.rows) = rows.by_point;
    n.in_front = n.in_front && rows.in_front;
    n.rows += 2;
  }
  n.information.noalias() = by_point.transpose() * by_point;
  n.gradient.noalias() = by_point.transpose() * error;
  n.cost = error.squaredNorm();
  return n;
}

}  // namespace

SightingNormal sighting_normal(const Rig* rig, const Sighting& sighting, const Vector3& x_in_sensor) {
  SightingNormal n;
  n.rows = row_count(sighting);
  if (sighting.point) {
    const double weight = point_weight(sighting) * point_weight(sighting);
    if (sighting.reading) {
      const ReadingResidual reading = reading_residual(sighting, x_in_sensor);
      n.information = weight * reading.by_point * reading.by_point.transpose();
      n.gradient = weight * reading.error * reading.by_point;
      n.cost = weight * reading.error * reading.error;
      return n;
    }
    const Vector3 error = *sighting.point - x_in_sensor;
    if (sighting.along) {
      const double along = sighting.along->dot(error);
      n.information = weight * *sighting.along * sighting.along->transpose();
      n.gradient = weight * along * *sighting.along;
      n.cost = weight * along * along;
      return n;
    }
    n.information = weight * Matrix3::Identity();
    n.gradient = weight * error;
    n.cost = weight * error.squaredNorm();
    return n;
  }
  check(rig != nullptr, "an image sighting of marker {} without cameras", sighting.marker);
  if (sighting.in_cameras.size() <= 2) return normal_of_two(*rig, sighting, x_in_sensor);
  for (const CameraPoint& seen : sighting.in_cameras) {
    const CameraRows rows = camera_rows(*rig, seen, sighting.usual_sigma, x_in_sensor);
    n.information.noalias() += rows.by_point.transpose() * rows.by_point;
    n.gradient.noalias() += rows.by_point.transpose() * rows.error;
    n.cost += rows.error.squaredNorm();
    n.in_front = n.in_front && rows.in_front;
  }
  return n;
}

int row_count(const Sighting& sighting) {
  if (sighting.along || sighting.reading) return 1;
  return sighting.point ? 3 : 2 * static_cast<int>(sighting.in_cameras.size());
}

namespace {

std::optional<SeenPoint> triangulated(const Rig& rig, const Sighting& s, bool is_weighed) {
  std::array<View, max_cameras> views;
  std::size_t count = 0;
  for (const CameraPoint& seen : s.in_cameras) {
    View& view = views[count++];
    view = {&rig.at(seen.camera).camera, &rig.at(seen.camera).camera_from_first, seen.pixel};
    if (is_weighed && seen.sigma && s.usual_sigma > 0)
      view.covariance = make_covariance(*seen.sigma) / (s.usual_sigma * s.usual_sigma);
  }
  return triangulate(std::span<const View>(views.data(), count));
}

}  // namespace

std::optional<SeenPoint> triangulate(const Rig& rig, const Sighting& sighting) {
  return triangulated(rig, sighting, true);
}

std::optional<SeenPoint> triangulate_unweighed(const Rig& rig, const Sighting& sighting) {
  return triangulated(rig, sighting, false);
}

}  // namespace handsight
