// SPDX-License-Identifier: Apache-2.0
#include "model/sighting.h"

#include <gtest/gtest.h>

#include "fixtures/arms.h"

namespace handsight {
namespace {

Sighting seen_by(const StereoRig& rig, const Vector3& x, bool left, bool right) {
  Sighting s;
  if (left) s.left = project(rig.left, x) + Vector2(0.3, -0.2);
  if (right) s.right = project(rig.right, Vector3(rig.right_from_left * x)) + Vector2(-0.1, 0.4);
  return s;
}

TEST(Sighting, ColumnsAgreeWithDifferences) {
  const StereoRig rig = *fixture::stand_session().stereo;
  const Vector3 x(0.1, -0.05, 1.1);
  for (const bool left : {true, false})
    for (const bool right : {true, false}) {
      const Sighting s = seen_by(rig, x, left, right);
      const SightingResidual r = sighting_residual(&rig, s, x);
      EXPECT_EQ(r.rows, (left ? 2 : 0) + (right ? 2 : 0));
      EXPECT_EQ(r.rows, row_count(s));
      for (int k = 0; k < 3; ++k) {
        const Vector3 h = 1e-6 * Vector3::Unit(k);
        const auto more = sighting_residual(&rig, s, x + h), less = sighting_residual(&rig, s, x - h);
        EXPECT_LT((r.by_point.col(k) + (more.error - less.error) / 2e-6).norm(), 1e-5);  // error = measured - predicted
      }
    }
}

TEST(Sighting, NormalEquationsAreThoseOfTheRows) {
  const StereoRig rig = *fixture::stand_session().stereo;
  const Vector3 x(0.1, -0.05, 1.1);
  const Sighting s = seen_by(rig, x, true, true);
  const SightingResidual r = sighting_residual(&rig, s, x);
  const SightingNormal n = sighting_normal(&rig, s, x);
  EXPECT_LT((n.information - r.by_point.transpose() * r.by_point).norm(), 1e-9 * n.information.norm());
  EXPECT_LT((n.gradient - r.by_point.transpose() * r.error).norm(), 1e-12 * n.information.norm());
  EXPECT_NEAR(n.cost, 0.09 + 0.04 + 0.01 + 0.16, 1e-12);
}

TEST(Sighting, APointIsItsOwnMeasurement) {
  Sighting s;
  s.point = Vector3(1, 2, 3);
  const SightingResidual r = sighting_residual(nullptr, s, Vector3(1, 2, 2.5));
  EXPECT_EQ(r.rows, 3);
  EXPECT_LT((r.error.head<3>() - Vector3(0, 0, 0.5)).norm(), 1e-15);
}

TEST(Sighting, SaysWhenThePointIsBehindTheCamera) {
  const StereoRig rig = *fixture::stand_session().stereo;
  EXPECT_FALSE(sighting_residual(&rig, seen_by(rig, Vector3(0, 0, 1), true, true), Vector3(0.1, 0, -1)).in_front);
}

}  // namespace
}  // namespace handsight
