// SPDX-License-Identifier: Apache-2.0
#include "widgets/scene/orbit.h"

#include <gtest/gtest.h>

#include <random>

#include "fixtures/drawn.h"

namespace handsight::widgets {
namespace {

/// Where the points lie in the view, from -1 to 1 of its width and of its height, up; the furthest of each side.
struct Margins {
  double left = 1, right = -1, bottom = 1, top = -1;
};

Margins margins_of(const Orbit& orbit, const std::vector<Vector3>& points, double aspect) {
  const Vector3 forward = orbit.direction(), right = forward.cross(Vector3::UnitZ()).normalized();
  const Vector3 up = right.cross(forward);
  const double slope = std::tan(Orbit::view_angle / 2 * M_PI / 180);
  Margins m;
  for (const Vector3& point : points) {
    const Vector3 d = point - orbit.eye();
    const double depth = d.dot(forward);
    EXPECT_GT(depth, 0);
    const double x = d.dot(right) / depth / slope / aspect, y = d.dot(up) / depth / slope;
    m = {std::min(m.left, x), std::max(m.right, x), std::min(m.bottom, y), std::max(m.top, y)};
  }
  return m;
}

/// All in sight, and no nearer place of the eye would have them so: between the sides or between top and bottom nothing
/// is left over.
TEST(Orbit, SeesPointsWholeAndAsLargeAsTheyGo) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> metres(-1, 1);
  for (const double aspect : {0.5, 1.3, 2.2})
    for (const double covered : {0.0, 0.1})
      for (int round = 0; round < 20; ++round) {
        std::vector<Vector3> points(12);
        for (Vector3& p : points)
          p = fixture::drawn_3([&] { return metres(random); }).cwiseProduct(Vector3(1, 0.4, 1.5));
        Orbit orbit;
        orbit.azimuth = 3 * metres(random);
        orbit.elevation = metres(random);
        orbit.see_points(points, aspect, covered);
        const Margins m = margins_of(orbit, points, aspect);
        const double used = 0.88, top = used - 2 * covered, slack = 1e-6;
        EXPECT_GT(m.left, -used - slack);
        EXPECT_LT(m.right, used + slack);
        EXPECT_GT(m.bottom, -used - slack);
        EXPECT_LT(m.top, top + slack) << "the buttons stand above";
        const bool is_wide = m.left < -used + slack && m.right > used - slack;
        const bool is_high = m.bottom < -used + slack && m.top > top - slack;
        EXPECT_TRUE(is_wide || is_high) << aspect << ", " << covered;
      }
}

}  // namespace
}  // namespace handsight::widgets
