// SPDX-License-Identifier: Apache-2.0
#include "camera/camera.h"

#include <cmath>

namespace handsight {
namespace {

struct Distorted {
  Vector2 point;             // xd, yd
  Eigen::Matrix2d jacobian;  // by x', y'
};

Distorted distort(const Camera& c, double x, double y) {
  const double r2 = x * x + y * y;
  const double radial = 1 + r2 * (c.k1 + r2 * (c.k2 + r2 * c.k3));
  const double radial_slope = 2 * (c.k1 + r2 * (2 * c.k2 + r2 * 3 * c.k3));  // d radial / d r2 * 2
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
  Eigen::Matrix<double, 2, 4> distorted_by_terms;                        // k1, k2, p1, p2
  distorted_by_terms << x * r2, x * r2 * r2, 2 * x * y, r2 + 2 * x * x,  //
      y * r2, y * r2 * r2, r2 + 2 * y * y, 2 * x * y;
  Eigen::Matrix2d pixel_by_distorted;
  pixel_by_distorted << c.fx, c.skew, 0, c.fy;
  Eigen::Matrix<double, 2, 8> m;
  m.leftCols<4>() << distorted.x(), 0, 1, 0, 0, distorted.y(), 0, 1;
  m.rightCols<4>() = pixel_by_distorted * distorted_by_terms;
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
