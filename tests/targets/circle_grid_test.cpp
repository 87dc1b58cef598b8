// SPDX-License-Identifier: Apache-2.0
// Grids of circles: described, printed, found.
#include "print/circle_grid.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "fixtures/target_images.h"
#include "print/target_xml.h"
#include "targets/circle_fit.h"
#include "targets/target_detection.h"

namespace handsight {
namespace {

using fixtures::TargetView;
using testing::HasSubstr;

const Target symmetric = target_from_words({{"kind", "circles"},
                                            {"columns", "7"},
                                            {"rows", "6"},
                                            {"spacing", "0.03"},
                                            {"diameter", "0.018"},
                                            {"layout", "symmetric"}},
                                           "test");
const Target asymmetric = target_from_words({{"kind", "circles"},
                                             {"columns", "4"},
                                             {"rows", "11"},
                                             {"spacing", "0.02"},
                                             {"diameter", "0.02"},
                                             {"layout", "asymmetric"}},
                                            "test");

Camera circle_camera() {
  return {.width = 640, .height = 480, .fx = 620, .fy = 622, .cx = 322, .cy = 236, .k1 = -0.18, .k2 = 0.06};
}

TargetView find_view(const Target& target, double distance, double turn_x, double turn_y, double turn_z = 0.2) {
  const PrintedPattern pattern = pattern_of(target);
  const Vector2 centre = pattern.outline.top_left + 0.5 * pattern.outline.size;
  TargetView view;
  view.camera = circle_camera();
  view.camera_from_target.rotation =
      rotation_from_vector<double>(Vector3(turn_x, turn_y, 0)) * rotation_from_vector<double>(Vector3(0, 0, turn_z));
  view.camera_from_target.translation =
      Vector3(0, 0, distance) - view.camera_from_target.rotation * Vector3(centre.x(), centre.y(), 0);
  return view;
}

struct Errors {
  std::size_t points = 0;
  double rms = 0, worst = 0, normalised = 0;  // px, px, 2 is right
  std::string reason;
};

Errors errors_of(const Target& target, const TargetView& view) {
  static const auto rays = fixtures::fine_rays(circle_camera());
  const TargetSighting sighting = detect_target(make_image(target, view, rays), prepare(target));
  Errors e{sighting.points.size(), 0, 0, 0, sighting.reason};
  for (const TargetPixel& p : sighting.points) {
    const Vector3 x = view.camera_from_target * target_points(target)[static_cast<std::size_t>(p.number)].position;
    const Vector2 off = p.pixel - project(view.camera, x);
    e.worst = std::max(e.worst, off.norm());
    e.rms += off.squaredNorm() / static_cast<double>(e.points);
    e.normalised += off.dot(p.covariance.inverse() * off) / static_cast<double>(e.points);
  }
  e.rms = std::sqrt(e.rms);
  return e;
}

TEST(CircleGrid, MiddlesOfBothLayoutsAreFound) {
  for (const Target& target : {symmetric, asymmetric})
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, {0.6, 0.2}, {-0.3, 0.7}}) {
      const Errors e = errors_of(target, find_view(target, 0.4, x, y));
      ASSERT_EQ(e.points, target_points(target).size()) << target.dictionary << x << y << ": " << e.reason;
      EXPECT_LT(e.rms, 0.05) << target.dictionary << x << y;
      EXPECT_LT(e.worst, 0.2);
      EXPECT_GT(e.normalised, 0.4) << target.dictionary << x << y;
      EXPECT_LT(e.normalised, 6) << target.dictionary << x << y;
    }
}

/// Large circles under a steep tilt: the ellipses' centres are a fifth of a pixel and more from the circles' middles.
TEST(CircleGrid, PerspectiveMovesNoMiddle) {
  Target large = symmetric;
  large.columns = 4, large.rows = 3, large.square = 0.05, large.tag = 0.045;
  TargetView view = find_view(large, 0.3, 0.95, 0.1);
  view.noise = 1;
  const Errors e = errors_of(large, view);
  ASSERT_EQ(e.points, 12U) << e.reason;
  EXPECT_LT(e.rms, 0.06);
}

/// An asymmetric grid of an odd number of rows has one beginning, however it lies.
TEST(CircleGrid, AsymmetricGridsBeginWhereTheyDo) {
  for (const double turn : {0.1, 1.5, 2.9, -1.7}) {
    const Errors e = errors_of(asymmetric, find_view(asymmetric, 0.4, 0.2, 0.3, turn));
    ASSERT_EQ(e.points, 44U) << turn << e.reason;
    EXPECT_LT(e.worst, 0.3) << turn;
  }
  EXPECT_FALSE(looks_the_same_turned(asymmetric));
  EXPECT_TRUE(looks_the_same_turned(symmetric));
}

TEST(CircleGrid, HalfAGridIsNone) {
  TargetView view = find_view(symmetric, 0.4, 0.3, -0.2);
  view.covers = {{{-100, 250}, {740, 250}, {740, 700}, {-100, 700}}};
  view.cover_greys = {90};
  const Errors e = errors_of(symmetric, view);
  EXPECT_EQ(e.points, 0U);
  EXPECT_THAT(e.reason, HasSubstr("7 x 6 circles"));
}

TEST(CircleGrid, WordsComeBack) {
  for (const Target& target : {symmetric, asymmetric}) {
    const Target again = target_from_words(target_words(target), "test");
    EXPECT_EQ(again.dictionary, target.dictionary);
    EXPECT_EQ(again.tag, target.tag);
    EXPECT_EQ(again.square, target.square);
    EXPECT_EQ(target_points(again).size(), target_points(target).size());
  }
  EXPECT_EQ(target_points(asymmetric)[4].position, Vector3(0.02, 0.02, 0));
  EXPECT_EQ(describe_target(asymmetric), "asymmetric grid of 4 x 11 circles of 20 mm, unit 20 mm");
}

TEST(CircleGrid, WhatCannotBeIsRefused) {
  auto words = target_words(symmetric);
  const auto with = [&](const std::string& name, const std::string& text) {
    auto other = words;
    for (auto& [word, value] : other)
      if (word == name) value = text;
    return other;
  };
  const auto refusal = [](const auto& of) {
    try {
      target_from_words(of, "test");
    } catch (const InputError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_THAT(refusal(with("layout", "old")), HasSubstr("symmetric or asymmetric"));
  EXPECT_THAT(refusal(with("diameter", "0.031")), HasSubstr("do not touch"));
  words.erase(words.begin() + 4);
  EXPECT_THAT(refusal(words), HasSubstr("diameter, which is missing"));
}

TEST(CircleGrid, WhatIsPrintedIsRound) {
  double area = 0;
  for (const Box& box : pattern_of(symmetric).black) area += box.size.x() * box.size.y();
  EXPECT_NEAR(area / (42 * M_PI * 0.009 * 0.009), 1, 1e-3);
  const BlackAt black_at(asymmetric);
  EXPECT_TRUE(black_at(0.02, 0.02) && black_at(0.0099, 0) && black_at(0.0, 0.0099));
  EXPECT_FALSE(black_at(0.0101, 0) || black_at(0.02, 0) || black_at(-0.02, 0.02));
}

TEST(CircleFit, CentreOfAnExactEllipse) {
  std::vector<Tangent> tangents;
  for (int i = 0; i < 40; ++i) {
    const double t = 2 * M_PI * i / 40;
    const Vector2 point(100 + 20 * std::cos(t), 50 + 8 * std::sin(t)), out(std::cos(t) / 20, std::sin(t) / 8);
    tangents.push_back({point, out.normalized(), 1});
  }
  const auto ellipse = fit_ellipse(tangents, {98, 51}, 12);
  ASSERT_TRUE(ellipse);
  EXPECT_LT((ellipse->centre - Vector2(100, 50)).norm(), 1e-9);
  EXPECT_NEAR(ellipse->shape(0, 0), 400, 1e-6);
  EXPECT_NEAR(ellipse->shape(1, 1), 64, 1e-6);
  tangents.resize(5);
  EXPECT_FALSE(fit_ellipse(tangents, {98, 51}, 12));
}

}  // namespace
}  // namespace handsight
