// SPDX-License-Identifier: Apache-2.0
#include "camera/lens.h"

#include <gtest/gtest.h>

#include <opencv2/calib3d.hpp>
#include <random>

namespace handsight {
namespace {

Lens sample(const LensModel& model) {
  Lens lens{&model, 640, 480, std::vector<double>(model.numbers.size(), 0)};
  const double brown[] = {520, 515, 322, 236, -0.21, 0.07, 8e-4, -5e-4, 0.012, 0.05, -0.02, 0.004};
  const double fisheye[] = {300, 304, 322, 236, -0.03, 0.011, -0.006, 0.001};
  for (std::size_t i = 0; i < lens.numbers.size(); ++i)
    lens.numbers[i] = &model == &fisheye_lens ? fisheye[i] : brown[i];
  return lens;
}

std::vector<Vector3> points(double widest) {
  std::vector<Vector3> list;
  for (double t = 0; t < widest; t += 0.11)
    for (double a = 0.1; a < 6.2; a += 0.7)
      list.emplace_back(1.7 * std::sin(t) * std::cos(a), 1.7 * std::sin(t) * std::sin(a), 1.7 * std::cos(t));
  return list;
}

double widest(const LensModel& model) { return &model == &fisheye_lens ? 1.5 : 0.65; }

/// The claim of the list: every model describes itself, once.
TEST(Lens, ModelsDescribeThemselves) {
  std::vector<std::string_view> names;
  for (const LensModel* model : lens_models()) {
    EXPECT_EQ(find_lens_model(model->name), model);
    for (const std::string_view name : names) EXPECT_NE(name, model->name);
    names.push_back(model->name);
    ASSERT_GE(model->numbers.size(), 4u);
    for (const LensNumber& number : model->numbers) {
      EXPECT_FALSE(number.name.empty());
      EXPECT_TRUE(number.unit == "px" || number.unit == "1");
      EXPECT_GT(number.prior_sigma_of, 0);
    }
  }
  EXPECT_EQ(lens_models()[0], &brown_lens);
  EXPECT_EQ(find_lens_model("pinhole"), nullptr);
}

/// Central differences of step 1e-6 are good to 1e-6 px here (fourth derivatives and rounding together).
TEST(Lens, DerivativesAgreeWithDifferences) {
  for (const LensModel* model : lens_models()) {
    const Lens lens = sample(*model);
    for (const Vector3& x : points(widest(*model))) {
      LensProjection p;
      model->project(lens.numbers, x, p);
      for (int i = 0; i < 3; ++i) {
        const Vector3 step = 1e-6 * Vector3::Unit(i);
        const Vector2 slope = (project(lens, x + step) - project(lens, x - step)) / 2e-6;
        EXPECT_LT((slope - p.by_point.col(i)).norm(), 1e-5 * (1 + slope.norm()))
            << model->name << " by coordinate " << i;
      }
      for (std::size_t i = 0; i < lens.numbers.size(); ++i) {
        Lens more = lens, less = lens;
        const double step = 1e-6 * std::max(1.0, std::abs(lens.numbers[i]));
        more.numbers[i] += step, less.numbers[i] -= step;
        const Vector2 slope = (project(more, x) - project(less, x)) / (2 * step);
        EXPECT_LT((slope - p.by_numbers.col(static_cast<Eigen::Index>(i))).norm(), 1e-5 * (1 + slope.norm()))
            << model->name << " by " << model->numbers[i].name;
      }
    }
  }
}

/// The outside authority: OpenCV's projectPoints and fisheye::projectPoints, to rounding.
TEST(Lens, ProjectsAsOpenCV) {
  for (const LensModel* model : lens_models()) {
    const Lens lens = sample(*model);
    const auto& n = lens.numbers;
    const cv::Matx33d k(n[0], 0, n[2], 0, n[1], n[3], 0, 0, 1);
    std::vector<double> distortion(n.begin() + 4, n.end());
    for (const Vector3& x : points(widest(*model))) {
      const std::vector<cv::Point3d> in{{x.x(), x.y(), x.z()}};
      std::vector<cv::Point2d> out;
      if (model == &fisheye_lens)
        cv::fisheye::projectPoints(in, out, cv::Vec3d(), cv::Vec3d(), k, distortion);
      else
        cv::projectPoints(in, cv::Vec3d(), cv::Vec3d(), k, distortion, out);
      EXPECT_LT((project(lens, x) - Vector2(out[0].x, out[0].y)).norm(), 1e-8) << model->name;
    }
  }
}

TEST(Lens, LiftUndoesProjection) {
  for (const LensModel* model : lens_models()) {
    const Lens lens = sample(*model);
    for (const Vector3& x : points(widest(*model))) {
      const auto ray = lift(lens, project(lens, x));
      ASSERT_TRUE(ray) << model->name;
      EXPECT_LT((*ray - x.normalized()).norm(), 1e-9) << model->name;
    }
  }
}

TEST(Lens, BrownIsTheCameraOfTheRestOfTheProgram) {
  const Lens lens = sample(brown_lens);
  const auto camera = look_up_camera(lens);
  ASSERT_TRUE(camera);
  for (const Vector3& x : points(0.6)) EXPECT_LT((project(lens, x) - project(*camera, x)).norm(), 1e-10);
  EXPECT_EQ(make_lens(*camera).numbers, lens.numbers);
  for (const LensModel* model : {&rational_lens, &fisheye_lens}) {
    const Lens other = sample(*model);
    for (const Vector3& x : points(0.6))
      EXPECT_LT((project(other, x) - project(*look_up_camera(other), x)).norm(), 1e-10);
    EXPECT_EQ(make_lens(*look_up_camera(other)).numbers, other.numbers);
  }
}

}  // namespace
}  // namespace handsight
