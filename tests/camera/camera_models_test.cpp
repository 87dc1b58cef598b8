// SPDX-License-Identifier: Apache-2.0
// Cameras with OpenCV's rational terms and fisheyes: beside OpenCV itself, derivatives, and undone.
#include <gtest/gtest.h>

#include <opencv2/calib3d.hpp>
#include <random>

#include "camera/camera.h"
#include "fixtures/drawn.h"

namespace handsight {
namespace {

Camera rational() {
  Camera c{.width = 1280, .height = 960, .fx = 700, .fy = 702, .cx = 640, .cy = 470, .k1 = 0.4, .k2 = -0.1, .p1 = 1e-3};
  c.p2 = -5e-4;
  c.k3 = 0.01;
  c.k4 = 0.5;
  c.k5 = 0.02;
  c.k6 = 0.001;
  return c;
}

Camera fisheye() {
  Camera c{.width = 1280, .height = 960, .fx = 480, .fy = 481, .cx = 640, .cy = 470, .k1 = 0.05, .k2 = -0.01};
  c.is_fisheye = true;
  c.k3 = 2e-3;
  c.k4 = -1e-3;
  return c;
}

std::vector<Vector3> places(double widest) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> across(-widest, widest), depth(0.4, 2);
  std::vector<Vector3> all{Vector3(0, 0, 1), Vector3(1e-6, 0, 1)};
  for (int i = 0; i < 40; ++i) {
    const double z = depth(random);
    const Vector2 aside = z * fixture::drawn_2([&] { return across(random); });
    all.push_back({aside.x(), aside.y(), z});
  }
  return all;
}

Vector2 by_opencv(const Camera& c, const Vector3& x) {
  const std::vector<cv::Point3d> point{{x.x(), x.y(), x.z()}};
  std::vector<cv::Point2d> pixel;
  const cv::Mat none = cv::Mat::zeros(3, 1, CV_64F);
  const cv::Mat k = (cv::Mat_<double>(3, 3) << c.fx, 0, c.cx, 0, c.fy, c.cy, 0, 0, 1);
  if (c.is_fisheye) {
    const cv::Mat d = (cv::Mat_<double>(4, 1) << c.k1, c.k2, c.k3, c.k4);
    cv::fisheye::projectPoints(point, pixel, none, none, k, d);
  } else {
    const cv::Mat d = (cv::Mat_<double>(8, 1) << c.k1, c.k2, c.p1, c.p2, c.k3, c.k4, c.k5, c.k6);
    cv::projectPoints(point, none, none, k, d, pixel);
  }
  return {pixel[0].x, pixel[0].y};
}

TEST(CameraModels, AreThoseOfOpenCv) {
  for (const Camera& c : {rational(), fisheye()})
    for (const Vector3& x : places(c.is_fisheye ? 2.5 : 0.8))
      EXPECT_LT((project(c, x) - by_opencv(c, x)).norm(), 1e-9) << c.is_fisheye << ' ' << x.transpose();
}

TEST(CameraModels, DerivativesAreThoseOfDifferences) {
  for (const Camera& c : {rational(), fisheye()})
    for (const Vector3& x : places(c.is_fisheye ? 2.5 : 0.8)) {
      Matrix23 by_point, ignored;
      EXPECT_LT((project_anywhere(c, x, by_point) - project(c, x)).norm(), 1e-9);
      for (int i = 0; i < 3; ++i) {
        const Vector3 step = 1e-6 * Vector3::Unit(i);
        const Vector2 slope = (project(c, Vector3(x + step)) - project(c, Vector3(x - step))) / 2e-6;
        EXPECT_LT((by_point.col(i) - slope).norm(), 1e-4 * (1 + slope.norm()));
      }
      const auto by_numbers = pixel_by_camera_numbers_anywhere(c, x);
      double Camera::*const numbers[] = {&Camera::fx, &Camera::fy, &Camera::cx, &Camera::cy,
                                         &Camera::k1, &Camera::k2, &Camera::p1, &Camera::p2};
      for (int i = 0; i < 8; ++i) {
        if (c.is_fisheye && i >= 6) {
          EXPECT_TRUE(by_numbers.col(i).isZero());
          continue;
        }
        Camera more = c, less = c;
        more.*numbers[i] += 1e-6;
        less.*numbers[i] -= 1e-6;
        const Vector2 slope = (project(more, x) - project(less, x)) / 2e-6;
        EXPECT_LT((by_numbers.col(i) - slope).norm(), 1e-4 * (1 + slope.norm())) << i;
      }
    }
}

TEST(CameraModels, AreUndone) {
  for (const Camera& c : {rational(), fisheye()})
    for (const Vector3& x : places(c.is_fisheye ? 2.5 : 0.8)) {
      const auto ray = undistort(c, project(c, x));
      ASSERT_TRUE(ray);
      EXPECT_LT((*ray - x.head<2>() / x.z()).norm(), 1e-9 * (1 + x.head<2>().squaredNorm()));
    }
}

TEST(CameraModels, WhatIsFarOutLeadsBack) {
  for (const Camera& c : {rational(), fisheye()})
    for (double angle = 0.05; angle < 3; angle += 0.05) {  // to nearly straight behind
      const Vector3 x(std::sin(angle), 0, std::cos(angle)), farther(std::sin(angle + 0.05), 0, std::cos(angle + 0.05));
      Matrix23 ignored;
      EXPECT_GT(project_anywhere(c, farther, ignored).x(), project_anywhere(c, x, ignored).x()) << angle;
    }
}

}  // namespace
}  // namespace handsight
