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

TEST(Sighting, ColumnsAgreeWithDifferencesBehindTheCamerasToo) {
  const StereoRig rig = *fixture::stand_session().stereo;
  const Sighting s = seen_by(rig, Vector3(0.1, -0.05, 1.1), true, true);
  for (const Vector3& x :
       {Vector3(0.3, 0.2, -1), Vector3(-0.4, 1, 1e-3), Vector3(2, -1, -1e-4), Vector3(3, 0.2, 0.5)}) {
    const SightingResidual r = sighting_residual(&rig, s, x);
    const CameraColumns by_cameras = camera_columns(rig, s, x);
    for (int k = 0; k < 3; ++k) {
      const Vector3 h = 1e-6 * Vector3::Unit(k);
      const auto more = sighting_residual(&rig, s, x + h), less = sighting_residual(&rig, s, x - h);
      EXPECT_LT((r.by_point.col(k) + (more.error - less.error) / 2e-6).norm(), 1e-6 * r.by_point.norm()) << x;
    }
    for (const int k : {0, 4, 10, 11, 12, 13, 18, 19, 20, 21}) {  // rig x, ry; k1 k2 p1 p2 of both
      StereoRig more = rig, less = rig;
      const double h = 1e-6;
      if (k < 6) {
        more.right_from_left = small_motion<double>(h * Vector6::Unit(k)) * rig.right_from_left;
        less.right_from_left = small_motion<double>(-h * Vector6::Unit(k)) * rig.right_from_left;
      } else {
        const auto number = [&](StereoRig& g) -> double& {
          Camera& c = k < 14 ? g.left : g.right;
          return k % 8 == 2 ? c.k1 : k % 8 == 3 ? c.k2 : k % 8 == 4 ? c.p1 : c.p2;
        };
        number(more) += h;
        number(less) -= h;
      }
      const Eigen::Vector4d slope =
          (sighting_residual(&less, s, x).error - sighting_residual(&more, s, x).error) / (2 * h);
      EXPECT_LT((by_cameras.col(k) - slope).norm(), 1e-5 * (1 + by_cameras.col(k).norm())) << k << " at " << x;
    }
  }
}

TEST(Sighting, LeadsBackFromBehindTheCamera) {
  Session session = fixture::stand_session();
  const Vector3 seen(0.1, -0.05, 1.1);
  for (const double focal : {1.0, 20.0}) {  // wide, telephoto
    StereoRig rig = *session.stereo;
    rig.left.fx *= focal;
    rig.left.fy *= focal;
    const Sighting s = seen_by(rig, seen, true, false);
    double last = 0;
    for (int step = 0; step < 3500; ++step) {
      const double angle = 0.05 * step * 0.0174532925;
      const Vector3 x = rotation_from_rpy({0, angle, 0}) * seen;
      const double size = sighting_residual(&rig, s, x).error.norm();
      EXPECT_GT(size, last) << angle << " rad off, focal length times " << focal;
      if (step > 0) {
        EXPECT_LT(size - last, 4 * 820 * focal * 8.7e-4) << "no jump; " << angle << " rad off";
      }
      last = size;
    }
  }
}

TEST(Sighting, IsWeighedByItsOwnSigma) {
  const StereoRig rig = *fixture::stand_session().stereo;
  const Vector3 x(0.1, -0.05, 1.1);
  Sighting s = seen_by(rig, x, true, true);
  const SightingResidual plain = sighting_residual(&rig, s, x);
  const CameraColumns plain_columns = camera_columns(rig, s, x);
  s.left_sigma = PixelSigma{0.4, 0.3, -0.05};
  s.usual_sigma = 0.2;
  const SightingResidual weighed = sighting_residual(&rig, s, x);
  const Eigen::Matrix2d inverse = 0.04 * covariance_of(*s.left_sigma).inverse();
  const auto left = [](const auto& m) { return m.template topRows<2>(); };
  EXPECT_LT((left(weighed.by_point).transpose() * left(weighed.by_point) -
             left(plain.by_point).transpose() * inverse * left(plain.by_point))
                .norm(),
            1e-9 * plain.by_point.squaredNorm());
  const Vector2 e = plain.error.head<2>();
  EXPECT_NEAR(weighed.error.head<2>().squaredNorm(), e.dot(inverse * e), 1e-12);
  EXPECT_EQ(weighed.error.tail<2>(), plain.error.tail<2>()) << "the right image has the usual sigma";
  const CameraColumns columns = camera_columns(rig, s, x);
  EXPECT_LT((left(columns).transpose() * left(weighed.by_point) -
             left(plain_columns).transpose() * inverse * left(plain.by_point))
                .norm(),
            1e-9 * plain_columns.norm() * plain.by_point.norm());
  s.usual_sigma = 0;
  EXPECT_EQ(sighting_residual(&rig, s, x).error, plain.error) << "without a usual sigma nothing is weighed";
  Sighting point{0, {}, {}, Vector3(1, 2, 3)};
  point.point_sigma = 1e-4;
  point.usual_sigma = 2e-4;
  EXPECT_LT((sighting_residual(nullptr, point, Vector3(1, 2, 2.5)).error.head<3>() - Vector3(0, 0, 1)).norm(), 1e-15);
}

}  // namespace
}  // namespace handsight
