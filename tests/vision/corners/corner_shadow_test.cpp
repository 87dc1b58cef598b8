// SPDX-License-Identifier: Apache-2.0
#include "vision/corners/corner_shadow.h"

#include <gtest/gtest.h>

#include <memory>

#include "fixtures/drawn.h"
#include "vision/corners/corner_images.h"
#include "vision/corners/corner_model.h"
#include "vision/corners/corner_patch.h"
#include "vision/corners/corner_structure.h"

namespace handsight {
namespace {

struct Beside {
  Eigen::Vector2d corner;
  Image image;
};

Beside marker_beside_shadow(double shade, double distance, double angle, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> half(-0.5, 0.5);
  corner_images::Light light;
  light.black = 40, light.white = 200, light.shade = shade;
  light.shade_distance = distance, light.shade_angle = angle;
  const Eigen::Vector2d corner = Eigen::Vector2d(32, 32) + fixture::drawn_2([&] { return half(random); });
  const auto view = corner_images::find_view(corner, 16, 0.3, 1, 0.4 + 0.3 * seed);
  return {corner, corner_images::render(65, 65, corner_images::marker(view, light), 1.2, 2, random)};
}

TEST(FitBesideShadow, FindsTheCornerAndTheShadow) {
  double squares = 0, plain_squares = 0;
  for (unsigned seed = 0; seed < 12; ++seed) {
    const double angle = 0.5 * seed, distance = 3.5 + 0.1 * seed;
    const Beside beside = marker_beside_shadow(0.5, distance, angle, seed);
    const auto cross = cross_structure(beside.image, beside.corner, 20, Lighting::shadowed);
    ASSERT_TRUE(cross) << seed;
    const auto plain = fit_corner(beside.image, beside.corner, *cross, 2);
    const CornerModel first = plain ? plain->model : first_guess(beside.corner, *cross);
    const Guess guess = plain ? Guess::fitted : Guess::from_circles;
    const auto fit = fit_beside_shadow(beside.image, beside.corner, *cross, first, guess, 2);
    ASSERT_TRUE(fit) << seed;
    const ShadowEdge& shadow = fit->model.shadow;
    EXPECT_NEAR(std::remainder(shadow.direction - angle, 2 * M_PI), 0, 0.1) << seed;
    EXPECT_NEAR(shadow.distance, distance, 0.4) << seed;
    EXPECT_NEAR(shadow.depth, 0.5, 0.1) << seed;
    EXPECT_NEAR(2 * std::abs(fit->model.half_contrast), 160, 16) << seed;
    squares += (fit->model.position - beside.corner).squaredNorm();
    plain_squares += plain ? (plain->model.position - beside.corner).squaredNorm() : 0.09;
  }
  EXPECT_LT(std::sqrt(squares / 12), 0.1);
  EXPECT_LT(squares, 0.5 * plain_squares) << "a fit without the shadow's edge is drawn aside";
}

TEST(FitBesideShadow, FindsNoneInEvenLight) {
  for (unsigned seed = 0; seed < 12; ++seed) {
    const Beside even = marker_beside_shadow(1, 5, 0, seed);
    const auto cross = cross_structure(even.image, even.corner, 20);
    ASSERT_TRUE(cross);
    const auto fit = fit_corner(even.image, even.corner, *cross, 2);
    ASSERT_TRUE(fit);
    EXPECT_FALSE(fit_beside_shadow(even.image, even.corner, *cross, fit->model, Guess::fitted, 2)) << seed;
  }
}

// What the board and the shadow's edge tell of a corner, each a little wrong.
CornerModel expected_of(const Beside& beside, double distance, double angle) {
  CornerModel expected;
  const auto cross = cross_structure(beside.image, beside.corner, 1, Lighting::shadowed);
  expected.position = beside.corner + Eigen::Vector2d(0.5, -0.4);
  if (cross) expected.edges = cross->edges, expected.half_contrast = cross->half_contrast > 0 ? 30 : -30;
  expected.blur = 1.3, expected.level = 90;
  expected.shadow = {angle + 0.05, distance + 0.4, 0.3, 1.6};
  return expected;
}

// However near its edge is: blurred with the corner's own edges it is no other light beside them.
TEST(FitInKnownShadow, FindsTheCornerHoweverNearTheEdgeRuns) {
  int found = 0, all = 0;
  double squares = 0, normalised = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    const double angle = 0.7 * seed, distance = 0.1 * (seed % 10) + 0.05;
    const Beside beside = marker_beside_shadow(0.4, distance, angle, seed);
    const CornerModel expected = expected_of(beside, distance, angle);
    if (expected.half_contrast == 0) continue;
    ++all;
    const auto fit = fit_in_known_shadow(beside.image, expected, 2);
    if (!fit) continue;
    ++found;
    const Eigen::Vector2d error = fit->model.position - beside.corner;
    squares += error.squaredNorm(), normalised += error.dot(fit->covariance.inverse() * error);
    EXPECT_LT(error.norm(), 0.3) << seed;
  }
  ASSERT_GE(all, 30);
  EXPECT_GE(found, all - 1);
  EXPECT_LT(std::sqrt(squares / found), 0.1);
  EXPECT_GT(normalised / found, 1);
  EXPECT_LT(normalised / found, 3.5);
}

// Neither grey levels nor depth need be known: both are read from the image where its edges lie.
TEST(LitAsSeen, ReadsGreyLevelsAndDepthWhereTheEdgesAreKnown) {
  for (unsigned seed = 0; seed < 8; ++seed) {
    const double angle = 0.8 * seed;
    const Beside beside = marker_beside_shadow(0.5, 2, angle, seed);
    const auto cross = cross_structure(beside.image, beside.corner, 20, Lighting::shadowed);
    ASSERT_TRUE(cross);
    CornerModel expected = first_guess(beside.corner, *cross);
    expected.blur = 1.25, expected.level = 300, expected.half_contrast *= 0.2;
    expected.shadow = {angle, 2, -0.5, 1.4};
    CornerPatch patch;
    const CornerModel seen = lit_as_seen(beside.image, expected, 6, patch);
    EXPECT_NEAR(seen.level, 120, 12) << seed;
    EXPECT_NEAR(std::abs(seen.half_contrast), 80, 12) << seed;
    EXPECT_NEAR(seen.shadow.depth, 0.5, 0.08) << seed;
  }
}

// The derivatives beside a shadow's edge that crosses the corner's, against differences of the residuals. By the angles
// and widths that only change how much edges share they are left out: there it need only be most of it.
TEST(EvaluateBesideShadow, HasTheDerivativesOfItsResiduals) {
  const Beside beside = marker_beside_shadow(0.5, 1.5, 0.7, 3);
  CornerModel model;
  model.position = beside.corner, model.edges = {0.3, 1.7}, model.blur = 1.2, model.level = 120;
  model.half_contrast = 70, model.shadow = {0.7, 1.5, 0.5, 1.5};
  const auto at = [&](const CornerModel& here) {
    auto patch = std::make_unique<CornerPatch>();
    gather(beside.image, nearest_pixel(beside.corner), 7, *patch);
    evaluate(here, 6, 0, patch->count, *patch);
    return patch;
  };
  const auto here = at(model);
  const auto compare = [&](const CornerPatch::Row& row, double share, const auto& change) {
    constexpr double step_size = 2e-3;
    CornerModel more = model, less = model;
    change(more, step_size), change(less, -step_size);
    const auto after = at(more), before = at(less);
    double apart = 0, all = 0;
    for (int n = 0; n < pixels_in_disc(4); ++n) {  // inside of the rim, which moves with the position
      const double slope = (before->residual[n] - after->residual[n]) / (2 * step_size);
      apart += (slope - row[n]) * (slope - row[n]), all += slope * slope;
    }
    EXPECT_LT(std::sqrt(apart / all), share);
  };
  const Eigen::Vector2d normal(std::cos(0.7), std::sin(0.7));
  for (int i = 0; i < 2; ++i)  // the line stays where it is
    compare(here->odd[i], 0.02,
            [&](CornerModel& m, double step) { m.position(i) += step, m.shadow.distance -= step * normal(i); });
  for (int i = 0; i < 2; ++i) compare(here->even[i], 0.35, [&](CornerModel& m, double step) { m.edges[i] += step; });
  compare(here->even[2], 0.35, [](CornerModel& m, double step) { m.blur += step; });
  compare(here->even[4], 0.02, [](CornerModel& m, double step) { m.half_contrast += step; });
  compare(here->shadow[0], 0.35, [](CornerModel& m, double step) { m.shadow.direction += step; });
  compare(here->shadow[1], 0.02, [](CornerModel& m, double step) { m.shadow.distance += step; });
  compare(here->shadow[2], 0.02, [](CornerModel& m, double step) { m.shadow.depth += step; });
  compare(here->shadow[3], 0.35, [](CornerModel& m, double step) { m.shadow.softness += step; });
}

TEST(LightAt, IsFullAtTheCornerAndLessBeyondTheEdge) {
  const ShadowEdge shadow{M_PI / 2, 6, 0.4, 1};
  EXPECT_NEAR(light_at(shadow, {0, 0}), 1, 1e-6);
  EXPECT_NEAR(light_at(shadow, {3, 6}), 0.8, 1e-9);
  EXPECT_NEAR(light_at(shadow, {0, 12}), 0.6, 1e-6);
}

}  // namespace
}  // namespace handsight
