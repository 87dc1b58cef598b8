// SPDX-License-Identifier: Apache-2.0
// OpenCV's fisheye (Kannala and Brandt, 2006): t = angle to the axis, td = t (1 + k1 t^2 + k2 t^4 + k3 t^6 + k4 t^8),
// u = fx td x/r + cx, v = fy td y/r + cy, r = hypot(x, y). Points beside and behind the camera are projected too.
#include <array>
#include <cmath>

#include "camera/lens.h"

namespace handsight {
namespace {

constexpr std::array<LensNumber, 8> fisheye_numbers{{{"fx", "px", 0.05},
                                                     {"fy", "px", 0.05},
                                                     {"cx", "px", 20},
                                                     {"cy", "px", 20},
                                                     {"k1", "1", 0.1},
                                                     {"k2", "1", 0.05},
                                                     {"k3", "1", 0.05},
                                                     {"k4", "1", 0.05}}};

double slope_of(std::span<const double> n, double t) {
  const double t2 = t * t;
  return 1 + t2 * (3 * n[4] + t2 * (5 * n[5] + t2 * (7 * n[6] + t2 * 9 * n[7])));
}

void project_fisheye(std::span<const double> n, const Vector3& p, LensProjection& out) {
  const double radius = p.head<2>().norm(), square = p.squaredNorm();
  const double t = std::atan2(radius, p.z()), t2 = t * t;
  const double bent = t * (1 + t2 * (n[4] + t2 * (n[5] + t2 * (n[6] + t2 * n[7]))));
  const bool is_on_axis = radius < 1e-12 * std::sqrt(square);
  const Vector2 direction = is_on_axis ? Vector2::Zero() : Vector2(p.head<2>() / radius);
  const Vector2 focal(n[0], n[1]);
  out.pixel = focal.cwiseProduct(bent * direction) + Vector2(n[2], n[3]);
  // bent / radius is 1 / z on the axis.
  const double ratio = is_on_axis ? 1 / p.z() : bent / radius;
  const double slope = slope_of(n, t);
  Matrix23 by_point;
  by_point.leftCols<2>() = ratio * (Eigen::Matrix2d::Identity() - direction * direction.transpose()) +
                           slope * p.z() / square * direction * direction.transpose();
  by_point.col(2) = -slope * radius / square * direction;
  out.by_point = focal.asDiagonal() * by_point;
  out.by_numbers.setZero(2, 8);
  out.by_numbers(0, 0) = bent * direction.x(), out.by_numbers(1, 1) = bent * direction.y();
  out.by_numbers(0, 2) = out.by_numbers(1, 3) = 1;
  double power = t;
  for (int i = 4; i < 8; ++i) {
    power *= t2;
    out.by_numbers.col(i) = power * focal.cwiseProduct(direction);
  }
}

bool fisheye_sees(std::span<const double> n, const Vector3& p) {
  const double t = std::atan2(p.head<2>().norm(), p.z());
  if (!(t < 2.2)) return false;  // 126 degrees: no lens sees farther
  for (const double share : {0.25, 0.5, 0.75, 1.0})
    if (!(slope_of(n, share * t) > 1e-3)) return false;
  return true;
}

}  // namespace

const LensModel fisheye_lens{"fisheye", "OpenCV's fisheye: k1 k2 k3 k4", fisheye_numbers, project_fisheye,
                             fisheye_sees};

}  // namespace handsight
