// SPDX-License-Identifier: Apache-2.0
// Brown's lens and OpenCV's rational extension of it: x' = x/z, y' = y/z, r2 = x'^2 + y'^2,
// radial = (1 + k1 r2 + k2 r2^2 + k3 r2^3) / (1 + k4 r2 + k5 r2^2 + k6 r2^3), tangential p1, p2;
// u = fx xd + cx, v = fy yd + cy.
#include <array>

#include "camera/lens.h"

namespace handsight {
namespace {

constexpr std::array<LensNumber, 12> brown_numbers{{{"fx", "px", 0.05},
                                                    {"fy", "px", 0.05},
                                                    {"cx", "px", 20},
                                                    {"cy", "px", 20},
                                                    {"k1", "1", 0.2},
                                                    {"k2", "1", 0.2},
                                                    {"p1", "1", 2e-3},
                                                    {"p2", "1", 2e-3},
                                                    {"k3", "1", 0.2},
                                                    {"k4", "1", 0.2},
                                                    {"k5", "1", 0.2},
                                                    {"k6", "1", 0.2}}};

struct RadialTerms {
  double value, slope;  // slope: by r2
  double above, below;
};

template <bool rational>
RadialTerms radial_of(std::span<const double> n, double r2) {
  RadialTerms r{};
  r.above = 1 + r2 * (n[4] + r2 * (n[5] + r2 * n[8]));
  const double above_slope = n[4] + r2 * (2 * n[5] + r2 * 3 * n[8]);
  r.below = 1;
  double below_slope = 0;
  if constexpr (rational) {
    r.below = 1 + r2 * (n[9] + r2 * (n[10] + r2 * n[11]));
    below_slope = n[9] + r2 * (2 * n[10] + r2 * 3 * n[11]);
  }
  r.value = r.above / r.below;
  r.slope = (above_slope - r.value * below_slope) / r.below;
  return r;
}

template <bool rational>
void project_brown(std::span<const double> n, const Vector3& p, LensProjection& out) {
  const double inverse = 1 / p.z(), x = p.x() * inverse, y = p.y() * inverse, r2 = x * x + y * y;
  const RadialTerms radial = radial_of<rational>(n, r2);
  const double p1 = n[6], p2 = n[7];
  const Vector2 distorted(x * radial.value + 2 * p1 * x * y + p2 * (r2 + 2 * x * x),
                          y * radial.value + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y);
  out.pixel = {n[0] * distorted.x() + n[2], n[1] * distorted.y() + n[3]};
  Eigen::Matrix2d by_normalised;
  const double cross = 2 * x * y * radial.slope + 2 * p1 * x + 2 * p2 * y;
  by_normalised << radial.value + 2 * x * x * radial.slope + 2 * p1 * y + 6 * p2 * x, cross, cross,
      radial.value + 2 * y * y * radial.slope + 6 * p1 * y + 2 * p2 * x;
  Matrix23 normalised_by_point;
  normalised_by_point << inverse, 0, -x * inverse, 0, inverse, -y * inverse;
  const Vector2 focal(n[0], n[1]);
  out.by_point = focal.asDiagonal() * by_normalised * normalised_by_point;
  out.by_numbers.setZero(2, rational ? 12 : 9);
  out.by_numbers(0, 0) = distorted.x(), out.by_numbers(1, 1) = distorted.y();
  out.by_numbers(0, 2) = out.by_numbers(1, 3) = 1;
  const Vector2 scaled(n[0] * x, n[1] * y);
  out.by_numbers.col(4) = scaled * (r2 / radial.below);
  out.by_numbers.col(5) = scaled * (r2 * r2 / radial.below);
  out.by_numbers.col(6) = focal.cwiseProduct(Vector2(2 * x * y, r2 + 2 * y * y));
  out.by_numbers.col(7) = focal.cwiseProduct(Vector2(r2 + 2 * x * x, 2 * x * y));
  out.by_numbers.col(8) = scaled * (r2 * r2 * r2 / radial.below);
  if constexpr (rational) {
    const double factor = -radial.value / radial.below;
    out.by_numbers.col(9) = scaled * (factor * r2);
    out.by_numbers.col(10) = scaled * (factor * r2 * r2);
    out.by_numbers.col(11) = scaled * (factor * r2 * r2 * r2);
  }
}

/// Every step toward the point must lead outward.
template <bool rational>
bool brown_sees(std::span<const double> n, const Vector3& p) {
  if (!(p.z() > 1e-9 * p.norm())) return false;
  const double r2 = p.head<2>().squaredNorm() / (p.z() * p.z());
  for (const double share : {0.25, 0.5, 0.75, 1.0}) {
    const RadialTerms radial = radial_of<rational>(n, share * r2);
    if (!(radial.below > 1e-6) || !(radial.value + 2 * share * r2 * radial.slope > 1e-3)) return false;
  }
  return true;
}

}  // namespace

const LensModel brown_lens{"brown", "Brown: k1 k2 p1 p2 k3", std::span(brown_numbers).first<9>(), project_brown<false>,
                           brown_sees<false>};
const LensModel rational_lens{"rational", "Brown with OpenCV's rational terms: k1 k2 p1 p2 k3 k4 k5 k6", brown_numbers,
                              project_brown<true>, brown_sees<true>};

}  // namespace handsight
