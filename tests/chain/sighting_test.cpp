// SPDX-License-Identifier: Apache-2.0
#include "chain/sighting.h"

#include <gtest/gtest.h>

#include "fixtures/rigs.h"

namespace handsight {
namespace {

Sighting sighted(const Rig& rig, const Vector3& x, bool left, bool right) {
  Sighting s;
  if (left) see(s, 0, project(rig.at(0).camera, x) + Vector2(0.3, -0.2));
  if (right) see(s, 1, project(rig.at(1).camera, Vector3(rig.at(1).camera_from_first * x)) + Vector2(-0.1, 0.4));
  return s;
}

TEST(Sighting, ColumnsAgreeWithDifferences) {
  const Rig rig = *fixture::stand_session().rig;
  const Vector3 x(0.1, -0.05, 1.1);
  for (const bool left : {true, false})
    for (const bool right : {true, false}) {
      const Sighting s = sighted(rig, x, left, right);
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
  const Rig rig = *fixture::stand_session().rig;
  const Vector3 x(0.1, -0.05, 1.1);
  const Sighting s = sighted(rig, x, true, true);
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
  const Rig rig = *fixture::stand_session().rig;
  EXPECT_FALSE(sighting_residual(&rig, sighted(rig, Vector3(0, 0, 1), true, true), Vector3(0.1, 0, -1)).in_front);
}

TEST(Sighting, ColumnsAgreeWithDifferencesBehindTheCamerasToo) {
  const Rig rig = *fixture::stand_session().rig;
  const Sighting s = sighted(rig, Vector3(0.1, -0.05, 1.1), true, true);
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
      Rig more = rig, less = rig;
      const double h = 1e-6;
      if (k < 6) {
        more.at(1).camera_from_first = small_motion<double>(h * Vector6::Unit(k)) * rig.at(1).camera_from_first;
        less.at(1).camera_from_first = small_motion<double>(-h * Vector6::Unit(k)) * rig.at(1).camera_from_first;
      } else {
        const auto number = [&](Rig& g) -> double& {
          Camera& c = g.at(k < 14 ? 0 : 1).camera;
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
    Rig rig = *session.rig;
    rig.at(0).camera.fx *= focal;
    rig.at(0).camera.fy *= focal;
    const Sighting s = sighted(rig, seen, true, false);
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
  const Rig rig = *fixture::stand_session().rig;
  const Vector3 x(0.1, -0.05, 1.1);
  Sighting s = sighted(rig, x, true, true);
  const SightingResidual plain = sighting_residual(&rig, s, x);
  const CameraColumns plain_columns = camera_columns(rig, s, x);
  seen_by(s, 0)->sigma = PixelSigma{0.4, 0.3, -0.05};
  s.usual_sigma = 0.2;
  const SightingResidual weighed = sighting_residual(&rig, s, x);
  const Eigen::Matrix2d inverse = 0.04 * make_covariance(*seen_by(s, 0)->sigma).inverse();
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
  Sighting point{.marker = 0, .point = Vector3(1, 2, 3)};
  point.point_sigma = 1e-4;
  point.usual_sigma = 2e-4;
  EXPECT_LT((sighting_residual(nullptr, point, Vector3(1, 2, 2.5)).error.head<3>() - Vector3(0, 0, 1)).norm(), 1e-15);
}

Sighting sighted_by_all(const Rig& rig, const Vector3& x) {
  Sighting s;
  for (int c = 0; c < rig.count(); ++c)
    see(s, c, project(rig.at(c).camera, Vector3(rig.at(c).camera_from_first * x)) + Vector2(0.1 * c, -0.2));
  return s;
}

TEST(Sighting, ColumnsOfEveryRigAgreeWithDifferences) {
  const Vector3 x(0.1, -0.05, 1.1);
  for (const int cameras : {1, 2, 3, 8}) {
    const Rig rig = *fixture::rig_session(cameras).rig;
    Sighting s = sighted_by_all(rig, x);
    if (cameras == 8) forget(s, 5);
    const SightingResidual r = sighting_residual(&rig, s, x);
    const CameraColumns by_cameras = camera_columns(rig, s, x);
    ASSERT_EQ(by_cameras.rows(), r.rows);
    ASSERT_EQ(by_cameras.cols(), 6 * (cameras - 1) + 8 * cameras);
    for (int k = 0; k < 3; ++k) {
      const Vector3 h = 1e-6 * Vector3::Unit(k);
      const auto more = sighting_residual(&rig, s, x + h), less = sighting_residual(&rig, s, x - h);
      EXPECT_LT((r.by_point.col(k) + (more.error - less.error) / 2e-6).norm(), 1e-6 * r.by_point.norm());
    }
    for (int c = 0; c < cameras; ++c) {
      const auto differ = [&](auto&& change, int column) {
        Rig more = rig, less = rig;
        change(more.at(c), 1e-6);
        change(less.at(c), -1e-6);
        const Eigen::VectorXd slope =
            (sighting_residual(&less, s, x).error - sighting_residual(&more, s, x).error) / 2e-6;
        EXPECT_LT((by_cameras.col(column) - slope).norm(), 1e-5 * (1 + slope.norm())) << cameras << " " << column;
      };
      for (int i = 0; i < 6 && c > 0; ++i)
        differ(
            [&](RigCamera& g, double h) {
              g.camera_from_first = small_motion<double>(h * Vector6::Unit(i)) * g.camera_from_first;
            },
            motion_number(c) + i);
      for (int i = 0; i < camera_number_count; ++i)
        differ(
            [&](RigCamera& g, double h) { g.camera.*camera_numbers(g.camera)[static_cast<std::size_t>(i)].value += h; },
            first_number(cameras, c) + i);
    }
  }
}

TEST(Sighting, NormalEquationsOfEveryRigAreThoseOfTheRows) {
  const Vector3 x(0.1, -0.05, 1.1);
  for (const int cameras : {1, 3, 5}) {
    const Rig rig = *fixture::rig_session(cameras).rig;
    const Sighting s = sighted_by_all(rig, x);
    const SightingResidual r = sighting_residual(&rig, s, x);
    const SightingNormal n = sighting_normal(&rig, s, x);
    EXPECT_EQ(n.rows, 2 * cameras);
    EXPECT_LT((n.information - r.by_point.transpose() * r.by_point).norm(), 1e-12 * n.information.norm());
    EXPECT_LT((n.gradient - r.by_point.transpose() * r.error).norm(), 1e-12 * n.information.norm());
    EXPECT_NEAR(n.cost, r.error.squaredNorm(), 1e-12);
  }
}

TEST(Sighting, IsTriangulatedByAllItsCameras) {
  const Vector3 x(0.1, -0.05, 1.1);
  EXPECT_FALSE(triangulate(*fixture::rig_session(1).rig, sighted_by_all(*fixture::rig_session(1).rig, x)));
  double before = 1e9;
  for (const int cameras : {2, 3, 5, 8}) {
    const Rig rig = *fixture::rig_session(cameras).rig;
    Sighting s;
    for (int c = cameras; c-- > 0;) see(s, c, project(rig.at(c).camera, Vector3(rig.at(c).camera_from_first * x)));
    EXPECT_EQ(s.in_cameras.front().camera, 0) << "in order whoever saw it first";
    const auto seen = triangulate(rig, s);
    ASSERT_TRUE(seen);
    EXPECT_LT((seen->point - x).norm(), 1e-10);
    EXPECT_LT(seen->covariance.trace(), before) << "more cameras see better";
    before = seen->covariance.trace();
  }
}

}  // namespace
}  // namespace handsight
