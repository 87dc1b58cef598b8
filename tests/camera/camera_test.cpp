// SPDX-License-Identifier: Apache-2.0
#include "camera/camera.h"

#include <gtest/gtest.h>

#include <opencv2/calib3d.hpp>
#include <random>

#include "fixtures/drawn.h"

namespace handsight {
namespace {

Camera distorted_camera() {
  Camera c;
  c.width = 640;
  c.height = 480;
  c.fx = 523.1;
  c.fy = 521.7;
  c.cx = 323.9;
  c.cy = 244.1;
  c.k1 = -0.25;
  c.k2 = 0.08;
  c.k3 = -0.01;
  c.p1 = 1.2e-3;
  c.p2 = -0.8e-3;
  return c;
}

StereoRig rig() {
  StereoRig r{distorted_camera(), distorted_camera(), {}};
  r.right.fx = 519;
  r.right.k1 = -0.22;
  r.right_from_left = {rotation_from_rpy({0.01, 0.08, -0.005}), {-0.12, 0.002, 0.004}};
  return r;
}

TEST(Project, AgreesWithOpenCV) {
  const Camera c = distorted_camera();
  const cv::Mat k = (cv::Mat_<double>(3, 3) << c.fx, 0, c.cx, 0, c.fy, c.cy, 0, 0, 1);
  const cv::Mat d = (cv::Mat_<double>(5, 1) << c.k1, c.k2, c.p1, c.p2, c.k3);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(-0.4, 0.4);
  for (int i = 0; i < 200; ++i) {
    const Vector3 x = Vector3(0, 0, 1) + fixture::drawn_3([&] { return uniform(random); });
    std::vector<cv::Point2d> pixel;
    cv::projectPoints(std::vector<cv::Point3d>{{x.x(), x.y(), x.z()}}, cv::Vec3d(), cv::Vec3d(), k, d, pixel);
    EXPECT_LT((project(c, x) - Vector2(pixel[0].x, pixel[0].y)).norm(), 1e-9);
  }
}

TEST(Project, SkewShearsTheImage) {
  Camera c = distorted_camera();
  const Vector2 without = project(c, Vector3(0.1, 0.2, 1));
  c.skew = 10;
  const Vector2 with = project(c, Vector3(0.1, 0.2, 1));
  EXPECT_NEAR(with.x() - without.x(), 10 * (without.y() - c.cy) / c.fy, 1e-12);
  EXPECT_EQ(with.y(), without.y());
}

TEST(Project, DerivativesAgreeWithDifferences) {
  const Camera c = distorted_camera();
  const Vector3 x(0.21, -0.17, 0.8);
  Matrix23 by_point;
  project(c, x, by_point);
  for (int k = 0; k < 3; ++k) {
    const Vector3 h = 1e-6 * Vector3::Unit(k);
    const Vector2 difference = (project(c, Vector3(x + h)) - project(c, Vector3(x - h))) / 2e-6;
    EXPECT_LT((by_point.col(k) - difference).norm(), 1e-5) << k;  // px/m, differences good to 1e-8 relative
  }
  const auto by_numbers = pixel_by_camera_numbers(c, x);
  double Camera::*const numbers[] = {&Camera::fx, &Camera::fy, &Camera::cx, &Camera::cy,
                                     &Camera::k1, &Camera::k2, &Camera::p1, &Camera::p2};
  for (int k = 0; k < 8; ++k) {
    Camera more = c, less = c;
    more.*numbers[k] += 1e-5;
    less.*numbers[k] -= 1e-5;
    EXPECT_LT((by_numbers.col(k) - (project(more, x) - project(less, x)) / 2e-5).norm(), 1e-6) << k;
  }
}

TEST(Undistort, IsTheInverseAllOverTheImage) {
  const Camera c = distorted_camera();
  for (int u = 0; u < c.width; u += 13)
    for (int v = 0; v < c.height; v += 13) {
      const auto normalised = undistort(c, Vector2(u, v));
      ASSERT_TRUE(normalised) << u << " " << v;
      EXPECT_LT((project(c, Vector3(normalised->homogeneous())) - Vector2(u, v)).norm(), 1e-9);
    }
}

TEST(Undistort, SaysWhereItCannot) {
  Camera c = distorted_camera();
  c.k1 = -0.5;  // folds back at r = 0.8: nothing maps farther out than 0.54
  c.k2 = c.k3 = c.p1 = c.p2 = 0;
  EXPECT_FALSE(undistort(c, Vector2(c.cx + 0.7 * c.fx, c.cy)));
}

TEST(Visible, NotBehindNotOutsideNotWhereTheLensFolds) {
  Camera c = distorted_camera();
  EXPECT_TRUE(is_visible(c, Vector3(0, 0, 1)));
  EXPECT_FALSE(is_visible(c, Vector3(0, 0, -1)));
  EXPECT_FALSE(is_visible(c, Vector3(0.9, 0, 1)));
  c.k1 = -0.5;
  c.k2 = c.k3 = 0;
  EXPECT_FALSE(is_visible(c, Vector3(1.35, 0, 1)));  // would come back to the middle of the image
}

TEST(Triangulate, RecoversThePointAndItsCovariance) {
  const StereoRig r = rig();
  const Vector3 truth(0.12, -0.05, 0.7);
  const Vector2 left = project(r.left, truth), right = project(r.right, r.right_from_left * truth);
  const auto exact = triangulate(r, left, right);
  ASSERT_TRUE(exact);
  EXPECT_LT((exact->point - truth).norm(), 1e-10);
  EXPECT_LT(exact->epipolar_distance, 1e-8);

  std::mt19937_64 random(7);
  std::normal_distribution<double> noise(0, 0.3);
  Matrix3 repeatability = Matrix3::Zero();
  const int trials = 4000;
  const Eigen::Matrix2d covariance = 0.09 * Eigen::Matrix2d::Identity();
  for (int i = 0; i < trials; ++i) {
    const auto off = [&] { return fixture::drawn_2([&] { return noise(random); }); };
    const Vector2 seen_right = right + off(), seen_left = left + off();
    const auto p = triangulate(r, seen_left, seen_right, covariance, covariance);
    ASSERT_TRUE(p);
    repeatability += (p->point - truth) * (p->point - truth).transpose() / trials;
  }
  const auto reported = triangulate(r, left, right, covariance, covariance)->covariance;
  for (int k = 0; k < 3; ++k)  // a sampled variance is good to sqrt(2/4000) = 2.2 %; four of those
    EXPECT_NEAR(repeatability(k, k) / reported(k, k), 1, 0.09) << k;
}

TEST(Triangulate, RefusesParallelRaysAndPointsBehind) {
  StereoRig r = rig();
  r.right = r.left;
  r.right_from_left.rotation.setIdentity();
  r.right_from_left.translation = {-0.12, 0, 0};
  EXPECT_FALSE(triangulate(r, Vector2(300, 200), Vector2(300, 200)));
  EXPECT_FALSE(triangulate(r, Vector2(300, 200), Vector2(330, 200)));  // disparity of the wrong sign
}

TEST(EpipolarDistance, IsInPixels) {
  const StereoRig r = rig();
  const Vector3 truth(0.05, 0.02, 0.6);
  const Vector2 left = project(r.left, truth);
  for (const double off : {0.5, 2.0, 6.0}) {
    const Vector2 right = project(r.right, r.right_from_left * truth) + Vector2(0, off);
    const double distance =
        epipolar_distance(r, essential_matrix(r), *undistort(r.left, left), *undistort(r.right, right));
    EXPECT_NEAR(distance, off, 0.06 * off) << off;  // lines are nearly horizontal; distortion stretches by some percent
  }
}

}  // namespace
}  // namespace handsight
