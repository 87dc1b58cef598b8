// SPDX-License-Identifier: Apache-2.0
#include "vision/corners/corner_crossing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace handsight {
namespace {

// The mean of sgn(d + b z) sgn(e + b z') over two normal numbers with the correlation r, of which the second is
// integrated in closed form.
double blurred_together(double d, double e, double r, double b) {
  constexpr int step_list = 200;
  constexpr double reach_px = 7;
  const auto integral = [&](double from, double to) {
    double sum = 0;
    for (int i = 0; i < step_list; ++i) {
      const double z = from + (to - from) * (i + 0.5) / step_list;
      sum += std::erf((e / b + r * z) / std::sqrt(2 * (1 - r * r))) * std::exp(-0.5 * z * z);
    }
    return sum * (to - from) / step_list / std::sqrt(2 * std::numbers::pi);
  };
  return integral(-d / b, reach_px) - integral(-reach_px, -d / b);
}

double crossing(double between, double blur, double d, double e) {
  const Crossing k(std::cos(between), std::sin(between), blur);
  Simd at_d = Simd{} + static_cast<float>(d), at_e = Simd{} + static_cast<float>(e);
  Shared<Simd> shared;
  share(k, at_d, at_e, shared);
  const double scale = M_SQRT1_2 / blur;
  return std::erf(scale * d) * std::erf(scale * e) + static_cast<double>(k.most * shared.bell[0]);
}

TEST(Crossing, IsWhatEdgesThatCrossAskewShare) {
  for (const double between : {0.65, 0.8, 1.1, std::numbers::pi / 2, 2.0, 2.3, -0.9})
    for (const double blur : {0.8, 2.5}) {
      const double r = std::cos(between), most = 0.05 * std::pow(std::abs(r), 3) + 1e-3;
      for (double d = -3 * blur; d <= 3 * blur; d += 0.3 * blur)
        for (double e = -3 * blur; e <= 3 * blur; e += 0.3 * blur)
          EXPECT_NEAR(crossing(between, blur, d, e), blurred_together(d, e, r, blur), most)
              << between << " rad, blur " << blur << ", " << d << " and " << e;
    }
}

TEST(Crossing, TurnsAsTheAngleBetweenTheEdgesDoes) {
  constexpr double step_size = 1e-3, blur_px = 1.3;
  for (const double between : {0.65, 1.1, 2.0, -0.9})
    for (double d = -2; d <= 2; d += 0.5)
      for (double e = -2; e <= 2; e += 0.5) {
        Shared<Simd> shared;
        Simd turn;
        const Crossing k(std::cos(between), std::sin(between), blur_px);
        share<Simd>(k, Simd{} + static_cast<float>(d), Simd{} + static_cast<float>(e), shared);
        turned(k, shared, turn);
        const double slope =
            (crossing(between + step_size, blur_px, d, e) - crossing(between - step_size, blur_px, d, e)) /
            (2 * step_size);
        EXPECT_NEAR(turn[0], -slope, 1e-3) << between << " rad, " << d << " and " << e;
      }
}

// The mean of sgn(d1) sgn(d2) over points that the lens moves, in the light of a shadow with a softness of its own:
// what product and shares make of it where the three edges do not all meet.
TEST(ShadowCrossing, IsWhatTheEdgesOfAShadowAndOfACornerShare) {
  constexpr double blur_px = 1.2, own_blur = 0.6;
  const double softness = std::hypot(blur_px, own_blur);
  for (const double between : {0.0, 0.4, 0.9, 1.3})  // of the normals
    for (double d = -3; d <= 3; d += 0.5)
      for (double e = -3; e <= 3; e += 0.5) {
        const double r = std::cos(between) * blur_px / softness;
        const ShadowCrossing k(std::cos(between), blur_px, softness, 1);
        Simd shared;
        k.share<Simd>(Simd{} + static_cast<float>(d), Simd{} + static_cast<float>(e), shared);
        const double product = std::erf(M_SQRT1_2 * d / blur_px) * std::erf(M_SQRT1_2 * e / softness);
        // With the blur as the unit of either distance.
        const double exact = blurred_together(d / blur_px, e / softness, r, 1);
        EXPECT_NEAR(product + shared[0], exact, 0.06 * std::pow(std::abs(r), 3) + 3e-3)
            << between << " rad, " << d << " and " << e;
      }
}

}  // namespace
}  // namespace handsight
