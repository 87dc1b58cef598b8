// SPDX-License-Identifier: Apache-2.0
#include "camera/camera.h"

#include <algorithm>
#include <cmath>

namespace handsight {
namespace {

struct Distorted {
  Vector2 point;             // xd, yd
  Eigen::Matrix2d jacobian;  // by x', y'
};

/// The radial factor and how it changes: by r2, and by k1 and k2.
struct Radial {
  double value, slope, by_k1, by_k2;
};

Radial fisheye_factor(const Camera& c, double r2) {
  if (r2 < 1e-8) return {1 + r2 * (c.k1 - 1.0 / 3), c.k1 - 1.0 / 3, r2, r2 * r2};  // the series of the rest
  const double r = std::sqrt(r2), t = std::atan(r), t2 = t * t;
  const double bent = t * (1 + t2 * (c.k1 + t2 * (c.k2 + t2 * (c.k3 + t2 * c.k4))));
  const double by_angle = 1 + t2 * (3 * c.k1 + t2 * (5 * c.k2 + t2 * (7 * c.k3 + t2 * 9 * c.k4)));
  const double slope = (by_angle / (1 + r2) - bent / r) / (2 * r2);
  return {bent / r, slope, t * t2 / r, t * t2 * t2 / r};
}

Radial rational_factor(const Camera& c, double r2) {
  const double above = 1 + r2 * (c.k1 + r2 * (c.k2 + r2 * c.k3)), below = 1 + r2 * (c.k4 + r2 * (c.k5 + r2 * c.k6));
  const double above_slope = c.k1 + r2 * (2 * c.k2 + r2 * 3 * c.k3);
  const double below_slope = c.k4 + r2 * (2 * c.k5 + r2 * 3 * c.k6);
  return {above / below, (above_slope - above / below * below_slope) / below, r2 / below, r2 * r2 / below};
}

Radial radial_of(const Camera& c, double r2) {
  if (c.is_fisheye) return fisheye_factor(c, r2);
  if (!is_plain(c)) return rational_factor(c, r2);
  return {1 + r2 * (c.k1 + r2 * (c.k2 + r2 * c.k3)), c.k1 + r2 * (2 * c.k2 + r2 * 3 * c.k3), r2, r2 * r2};
}

Distorted distort(const Camera& c, double x, double y) {
  const double r2 = x * x + y * y;
  const Radial factor = radial_of(c, r2);
  const double radial = factor.value, radial_slope = 2 * factor.slope;
  Distorted d;
  d.point = {x * radial + 2 * c.p1 * x * y + c.p2 * (r2 + 2 * x * x),
             y * radial + c.p1 * (r2 + 2 * y * y) + 2 * c.p2 * x * y};
  const double cross = x * y * radial_slope + 2 * c.p1 * x + 2 * c.p2 * y;
  d.jacobian << radial + x * x * radial_slope + 2 * c.p1 * y + 6 * c.p2 * x, cross, cross,
      radial + y * y * radial_slope + 6 * c.p1 * y + 2 * c.p2 * x;
  return d;
}

bool one_to_one(const Distorted& d) { return d.jacobian.determinant() > 1e-6 && d.jacobian(0, 0) > 0; }

}  // namespace

Vector2 project(const Camera& c, const Vector3& p, Matrix23& pixel_by_point) {
  const double inverse_depth = 1 / p.z();
  const double x = p.x() * inverse_depth;
  const double y = p.y() * inverse_depth;
  const Distorted d = distort(c, x, y);
  Matrix23 normalised_by_point;
  normalised_by_point << inverse_depth, 0, -x * inverse_depth, 0, inverse_depth, -y * inverse_depth;
  Eigen::Matrix2d pixel_by_distorted;
  pixel_by_distorted << c.fx, c.skew, 0, c.fy;
  pixel_by_point.noalias() = (pixel_by_distorted * d.jacobian).eval() * normalised_by_point;
  return pixel_by_distorted * d.point + Vector2(c.cx, c.cy);
}

Eigen::Matrix<double, 2, 8> pixel_by_camera_numbers(const Camera& c, const Vector3& p) {
  const double x = p.x() / p.z();
  const double y = p.y() / p.z();
  const double r2 = x * x + y * y;
  const Vector2 distorted = distort(c, x, y).point;
  const Radial by = radial_of(c, r2);
  Eigen::Matrix<double, 2, 4> distorted_by_terms;                               // k1, k2, p1, p2
  distorted_by_terms << x * by.by_k1, x * by.by_k2, 2 * x * y, r2 + 2 * x * x,  //
      y * by.by_k1, y * by.by_k2, r2 + 2 * y * y, 2 * x * y;
  if (c.is_fisheye) distorted_by_terms.rightCols<2>().setZero();
  Eigen::Matrix2d pixel_by_distorted;
  pixel_by_distorted << c.fx, c.skew, 0, c.fy;
  Eigen::Matrix<double, 2, 8> m;
  m.leftCols<4>() << distorted.x(), 0, 1, 0, 0, distorted.y(), 0, 1;
  m.rightCols<4>() = pixel_by_distorted * distorted_by_terms;
  return m;
}

namespace {

/// The tangent of the angle to the axis up to which `project` is taken as it is: 1.2 times the farthest corner's.
double cone_of(const Camera& c) {
  if (c.width <= 0 || c.height <= 0) return 3;
  if (c.is_fisheye) return 10;
  return 1.2 * std::hypot(std::max(c.cx, c.width - c.cx) / c.fx, std::max(c.cy, c.height - c.cy) / c.fy);
}

/// Without divisions and roots: asked at every measurement of every step.
bool is_in_cone(const Camera& c, const Vector3& p) {
  if (!(p.z() > 0)) return false;
  if (c.is_fisheye) return p.head<2>().squaredNorm() <= cone_of(c) * cone_of(c) * p.z() * p.z();
  if (c.width <= 0 || c.height <= 0) return p.head<2>().squaredNorm() <= 9 * p.z() * p.z();
  const double u = c.fy * std::max(c.cx, c.width - c.cx), v = c.fx * std::max(c.cy, c.height - c.cy);
  const double scale = c.fx * c.fy / 1.2;
  return p.head<2>().squaredNorm() * scale * scale <= (u * u + v * v) * p.z() * p.z();
}

/// A point beyond the cone: xd = direction * radial + tangential * q, q quadratic in the direction.
struct Beyond {
  Vector2 direction;        // from the axis to the point
  double radius = 0;        // m, from the axis
  double t = 0, extra = 0;  // normalised: the cone's, and how far beyond
  double slope = 0;         // d extra / d angle
};

Beyond beyond_cone(const Camera& c, const Vector3& p) {
  Beyond b;
  b.radius = p.head<2>().norm();
  b.direction = b.radius > 0 ? Vector2(p.head<2>() / b.radius) : Vector2::UnitX();  // straight behind: either way
  b.t = cone_of(c);
  b.slope = 1 + b.t * b.t;
  b.extra = b.slope * (std::atan2(b.radius, p.z()) - std::atan(b.t));
  return b;
}

/// How the distance from the axis grows at the cone: t radial(t^2) by t. Of a fisheye it hardly grows any more.
double radial_slope_at(const Camera& c, double t2) {
  if (is_plain(c)) return 1 + t2 * (3 * c.k1 + t2 * (5 * c.k2 + t2 * 7 * c.k3));
  const Radial radial = radial_of(c, t2);
  return radial.value + 2 * t2 * radial.slope;
}

/// Where the distortion would fold the image back it goes on outward all the same.
double least_slope(const Camera& c) { return c.is_fisheye ? 1e-3 : 0.2; }
double radial_slope_beyond(const Camera& c, double t2) { return std::max(radial_slope_at(c, t2), least_slope(c)); }

Vector2 tangential(const Camera& c, const Vector2& d) {
  return {2 * c.p1 * d.x() * d.y() + c.p2 * (1 + 2 * d.x() * d.x()),
          c.p1 * (1 + 2 * d.y() * d.y()) + 2 * c.p2 * d.x() * d.y()};
}

Vector2 distorted_beyond(const Camera& c, const Beyond& b) {
  const double t2 = b.t * b.t;
  const double radial = b.t * radial_of(c, t2).value + b.extra * radial_slope_beyond(c, t2);
  return b.direction * radial + (t2 + 2 * b.t * b.extra) * tangential(c, b.direction);
}

Eigen::Matrix2d pixel_by_distorted(const Camera& c) { return (Eigen::Matrix2d() << c.fx, c.skew, 0, c.fy).finished(); }

}  // namespace

Vector2 project_anywhere(const Camera& c, const Vector3& p, Matrix23& pixel_by_point) {
  if (is_in_cone(c, p)) return project(c, p, pixel_by_point);
  const Beyond b = beyond_cone(c, p);
  const double t2 = b.t * b.t, square = t2 + 2 * b.t * b.extra;
  const Vector2 d = b.direction, q = tangential(c, d);
  const double radial = b.t * radial_of(c, t2).value + b.extra * radial_slope_beyond(c, t2);
  Eigen::Matrix2d q_by_direction;
  q_by_direction << 2 * c.p1 * d.y() + 4 * c.p2 * d.x(), 2 * c.p1 * d.x(),  //
      2 * c.p2 * d.y(), 4 * c.p1 * d.y() + 2 * c.p2 * d.x();
  const Eigen::Matrix2d by_direction = radial * Eigen::Matrix2d::Identity() + square * q_by_direction;
  const Vector2 by_extra = d * radial_slope_beyond(c, t2) + 2 * b.t * q;
  const double distance2 = p.squaredNorm();
  Matrix23 by_point = Matrix23::Zero();
  if (b.radius > 0)
    by_point.leftCols<2>() = by_direction * (Eigen::Matrix2d::Identity() - d * d.transpose()) / b.radius;
  by_point.leftCols<2>() += by_extra * (b.slope * p.z() / distance2 * d.transpose());
  by_point.col(2) = by_extra * (-b.slope * b.radius / distance2);
  const Eigen::Matrix2d by_distorted = pixel_by_distorted(c);
  pixel_by_point = by_distorted * by_point;
  return by_distorted * distorted_beyond(c, b) + Vector2(c.cx, c.cy);
}

Eigen::Matrix<double, 2, 8> pixel_by_camera_numbers_anywhere(const Camera& c, const Vector3& p) {
  if (is_in_cone(c, p)) return pixel_by_camera_numbers(c, p);
  const Beyond b = beyond_cone(c, p);
  const double t2 = b.t * b.t, square = t2 + 2 * b.t * b.extra;
  // Beyond the cone the slope of other lenses than Brown's is taken as it is.
  const bool folds = !is_plain(c) || radial_slope_at(c, t2) < least_slope(c);
  const Radial by = radial_of(c, t2);
  const Vector2 d = b.direction, distorted = distorted_beyond(c, b);
  Eigen::Matrix<double, 2, 4> by_terms;  // k1, k2, p1, p2
  by_terms.col(0) = d * (b.t * by.by_k1 + (folds ? 0 : 3 * t2 * b.extra));
  by_terms.col(1) = d * (b.t * by.by_k2 + (folds ? 0 : 5 * t2 * t2 * b.extra));
  by_terms.col(2) = square * Vector2(2 * d.x() * d.y(), 1 + 2 * d.y() * d.y());
  by_terms.col(3) = square * Vector2(1 + 2 * d.x() * d.x(), 2 * d.x() * d.y());
  if (c.is_fisheye) by_terms.rightCols<2>().setZero();
  Eigen::Matrix<double, 2, 8> m;
  m.leftCols<4>() << distorted.x(), 0, 1, 0, 0, distorted.y(), 0, 1;
  m.rightCols<4>() = pixel_by_distorted(c) * by_terms;
  return m;
}

bool is_visible(const Camera& camera, const Vector3& p, double margin) {
  if (!(p.z() > 1e-6)) return false;
  const double x = p.x() / p.z();
  const double y = p.y() / p.z();
  // The distortion polynomial may fold back far outside the image: every step toward the point must stay one to one.
  for (const double share : {0.5, 0.75, 1.0})
    if (!one_to_one(distort(camera, share * x, share * y))) return false;
  const Vector2 pixel = project(camera, p);
  return pixel.x() >= margin && pixel.y() >= margin && pixel.x() <= camera.width - 1 - margin &&
         pixel.y() <= camera.height - 1 - margin;
}

std::optional<Vector2> undistort(const Camera& c, const Vector2& pixel) {
  const double yd = (pixel.y() - c.cy) / c.fy;
  const double xd = (pixel.x() - c.cx - c.skew * yd) / c.fx;
  Vector2 normalised(xd, yd);
  for (int iteration = 0; iteration < 50; ++iteration) {
    const Distorted d = distort(c, normalised.x(), normalised.y());
    if (!one_to_one(d)) return std::nullopt;
    const Vector2 error = d.point - Vector2(xd, yd);
    Vector2 step = d.jacobian.inverse() * error;
    // Far out the polynomial is steep: a bounded step keeps Newton inside the one-to-one region.
    const double limit = 0.5 * (1 + normalised.norm());
    if (step.norm() > limit) step *= limit / step.norm();
    normalised -= step;
    if (step.norm() < 1e-15 * (1 + normalised.norm())) break;
  }
  const Distorted d = distort(c, normalised.x(), normalised.y());
  if (!one_to_one(d) || (d.point - Vector2(xd, yd)).norm() > 1e-12 * (1 + std::hypot(xd, yd))) return std::nullopt;
  return normalised;
}

}  // namespace handsight
