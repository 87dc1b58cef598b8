// SPDX-License-Identifier: Apache-2.0
#include "vision/corner_cubic.h"

#include <gtest/gtest.h>

#include <memory>

#include "vision/corner_images.h"

namespace handsight {
namespace {

CornerModel model_at(const Eigen::Vector2d& position, double spin, double blur) {
  CornerModel model;
  model.position = position, model.edges = {spin, spin + M_PI / 2}, model.blur = blur;
  model.level = 120, model.half_contrast = 60;
  return model;
}

TEST(CornerCubic, OfACornerTheModelSaysMore) {
  std::mt19937 random(1);
  corner_images::Light light;
  light.black = 60, light.white = 180;
  const auto view = corner_images::view_of({20.3, 19.6}, 20, 0, 0, 0.3);
  for (const double blur : {0.7, 1.2, 2.0})
    for (int radius = 4; radius <= kMostPatchRadius; ++radius) {
      const Image image = corner_images::render(41, 41, corner_images::marker(view, light), blur, 2, random);
      CornerModel model = model_at(view.corner, 0.3, std::sqrt(blur * blur + 1 / 12.0));
      const auto patch = std::make_unique<CornerPatch>();
      const double as_it_is = cubic_over_model(image, model, radius, *patch);
      model.half_contrast *= -1;
      const double swapped = cubic_over_model(image, model, radius, *patch);
      EXPECT_GT(std::max(as_it_is, swapped), blur < 2 || radius > 5 ? 5 : 1.2) << blur << ' ' << radius;
      EXPECT_LT(std::min(as_it_is, swapped), 1) << blur << ' ' << radius;
    }
}

TEST(CornerCubic, OfACubicTheModelSaysLessAndOfAFlatImageNothingIsDividedByZero) {
  std::mt19937 random(2);
  const auto saddle = [](double u, double v) {
    const double x = (u - 20) / 10, y = (v - 20) / 10;
    return 120 + 50 * x * y + 15 * x * x * x - 20 * x * y * y;
  };
  const Image image = corner_images::render(41, 41, saddle, 0, 1, random);
  for (int radius = 4; radius <= kMostPatchRadius; ++radius) {
    const auto patch = std::make_unique<CornerPatch>(), other = std::make_unique<CornerPatch>();
    EXPECT_LT(cubic_over_model(image, model_at({20, 20}, 0, 2), radius, *patch), 1) << radius;
    CornerModel flat = model_at({20, 20}, 0, 1);
    flat.half_contrast = 0;
    const double of_nothing = cubic_over_model(Image(41, 41, 120), flat, radius, *other);
    EXPECT_TRUE(std::isfinite(of_nothing) && of_nothing < 1) << of_nothing;
  }
}

TEST(CornerPatch, SumsAreTheProductsOfTheRows) {
  std::mt19937 random(3);
  Image image(41, 41);
  for (auto& pixel : image.pixels) pixel = static_cast<std::uint8_t>(random() % 256);
  const auto patch = std::make_unique<CornerPatch>();
  for (int radius = 12; radius >= 3; --radius) {  // shrinking: what a larger disc left must not take part
    gather(image, {20, 20}, radius, *patch);
    evaluate(model_at({20.2, 19.7}, 0.4, radius % 2 ? 0.5 : 1.3), radius - 1, 0, patch->count, *patch);
    const PatchSums all = sums(*patch);
    const auto product = [&](const CornerPatch::Row& a, const CornerPatch::Row& b) {
      double sum = 0;
      for (int n = 0; n < patch->count; ++n) sum += static_cast<double>(a[n]) * b[n];
      return sum;
    };
    const auto expect = [&](double value, const CornerPatch::Row& a, const CornerPatch::Row& b) {
      EXPECT_NEAR(value, product(a, b), 1e-5 * std::sqrt(product(a, a) * product(b, b)) + 1e-6) << radius;
    };
    for (int i = 0, n = 0; i < 4; ++i) {
      for (int j = 0; j <= i; ++j) expect(all.odd[n++], patch->odd[i], patch->odd[j]);
      expect(all.odd_side[i], patch->odd[i], patch->residual);
    }
    for (int i = 0, n = 0; i < 5; ++i) {
      for (int j = 0; j <= i; ++j) expect(all.even[n++], patch->even[i], patch->even[j]);
      expect(all.even_side[i], patch->even[i], patch->residual);
    }
    expect(all.squares, patch->residual, patch->residual);
    expect(all.weights, patch->weight, patch->weight);
  }
}

}  // namespace
}  // namespace handsight
