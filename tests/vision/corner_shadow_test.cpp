// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "vision/corner_images.h"
#include "vision/corner_model.h"
#include "vision/corner_structure.h"

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
  const Eigen::Vector2d corner(32 + half(random), 32 + half(random));
  const auto view = corner_images::view_of(corner, 16, 0.3, 1, 0.4 + 0.3 * seed);
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

TEST(LightAt, IsFullAtTheCornerAndLessBeyondTheEdge) {
  const ShadowEdge shadow{M_PI / 2, 6, 0.4, 1};
  EXPECT_NEAR(light_at(shadow, {0, 0}), 1, 1e-6);
  EXPECT_NEAR(light_at(shadow, {3, 6}), 0.8, 1e-9);
  EXPECT_NEAR(light_at(shadow, {0, 12}), 0.6, 1e-6);
}

}  // namespace
}  // namespace handsight
